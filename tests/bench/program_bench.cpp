// The program as its users start it.
#include <benchmark/benchmark.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <string>

#include "bench/expectation.h"
#include "support/paths.h"
#include "support/temporary_folder.h"

namespace skydrop::bench {
namespace {

// A frame of 320 x 180, with the start of the program, all of the land, read-back and PNG, and every shader
// recompiled.
void frameWithAColdShaderCache(benchmark::State& state) {
  const test::TemporaryFolder folder;
  const std::string command = "MESA_SHADER_CACHE_DISABLE=true '" + test::programFile() +
                              "' render --scene terrain --size 320x180 --out '" +
                              (folder.path() / "frame.png").string() + "' > /dev/null";
  double worst = 0;
  for (auto _ : state) {
    const auto begin = std::chrono::steady_clock::now();
    expect(std::system(command.c_str()) == 0, "the program failed");
    worst = std::max(worst, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  state.counters["worstS"] = worst;
  expect(worst < 2, "a frame with a cold shader cache took more than 2 s");
}
BENCHMARK(frameWithAColdShaderCache)->Iterations(3)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace skydrop::bench
