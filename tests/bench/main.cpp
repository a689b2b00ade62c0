// Runs the benchmarks; the exit code is 1 when a promise was not kept (expectation.h). Without
// --benchmark_filter those whose name ends with "/byName" are left out: studies of many minutes that promise
// nothing.
#include <benchmark/benchmark.h>

#include <cstdio>

#include "bench/expectation.h"

namespace skydrop::bench {
namespace {

bool kept = true;

}  // namespace

void expect(bool keeps, const char* promise) {
  if (keeps) return;
  kept = false;
  std::fprintf(stderr, "A promise is not kept: %s.\n", promise);
}

bool allPromisesKept() { return kept; }

}  // namespace skydrop::bench

int main(int argc, char** argv) {
  benchmark::SetBenchmarkFilter("-byName");
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return skydrop::bench::allPromisesKept() ? 0 : 1;
}
