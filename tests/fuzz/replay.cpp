// The fuzz targets without libFuzzer, for the usual suites and any compiler: gives a target its seed corpus
// and damaged copies of it, the same ones in every run.
//   fuzz_replay TARGET EXECUTIONS FILE|FOLDER...
// An input that ends the program is kept as fuzz-TARGET-input in the current folder.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "fuzz/fuzz_targets.h"
#include "support/instrumented.h"
#include "support/mutants.h"

namespace {

using namespace skydrop;

const std::string* current = nullptr;
std::string keptName;

// Only calls that a signal handler may make.
void keepInput(int signal) {
  const int file = ::open(keptName.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (file >= 0 && current && ::write(file, current->data(), current->size()) >= 0) ::close(file);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

std::vector<std::filesystem::path> filesOf(int count, char** names) {
  std::vector<std::filesystem::path> files;
  for (int i = 0; i < count; ++i) {
    if (std::filesystem::is_directory(names[i])) {
      for (const auto& entry : std::filesystem::directory_iterator(names[i])) files.push_back(entry.path());
    } else {
      files.emplace_back(names[i]);
    }
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace

int main(int argc, char** argv) {
  const auto targets = fuzz::targets();
  const auto target = std::ranges::find(targets, argc > 3 ? argv[1] : "", &fuzz::Target::name);
  if (target == targets.end()) {
    std::fprintf(stderr, "usage: fuzz_replay TARGET EXECUTIONS FILE|FOLDER...\n");
    return 2;
  }
  keptName = "fuzz-" + std::string(target->name) + "-input";
  for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGALRM}) std::signal(signal, keepInput);
  std::size_t count = 0;
  const auto begin = std::chrono::steady_clock::now();
  const auto run = [&](const std::string& input) {
    constexpr unsigned kMostSeconds = 60;  // of wall clock: nothing that is read takes a second
    current = &input;
    ::alarm(kMostSeconds);
    target->run(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
    ++count;
  };
  std::vector<std::string> seeds;
  for (const auto& file : filesOf(argc - 3, argv + 3)) {
    std::ifstream stream(file, std::ios::binary);
    seeds.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
    run(seeds.back());
  }
  run("");
  const int rounds =
      test::repetitions(std::atoi(argv[2])) / static_cast<int>(std::max<std::size_t>(seeds.size(), 1));
  for (const std::string& seed : seeds) test::forEachMutant(seed, rounds, run);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  std::printf("%s: %zu inputs, %zu of them seeds, in %.1f s\n", argv[1], count, seeds.size(),
              seconds.count());
  return seeds.empty() ? 1 : 0;
}
