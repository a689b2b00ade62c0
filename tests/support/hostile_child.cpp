// A program that does to its parent what a library may do to a reader: tests of core/contained_process.h
// start it.
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "skydrop/core/contained_process.h"
#include "skydrop/core/file.h"

int main(int argc, char** argv) {
  using namespace skydrop;
  const std::string_view does = argc > 1 ? argv[1] : "";
  core::limitThisProcess({.wallSeconds = 60, .cpuSeconds = 1, .memoryBytes = std::size_t{512} << 20});
  if (does == "answers") core::writeContainedResult("an answer");
  if (does == "crashes") std::raise(SIGSEGV);
  if (does == "aborts") std::abort();
  if (does == "throws") throw 1;
  if (does == "fails") return 7;
  if (does == "hangs") std::this_thread::sleep_for(std::chrono::hours(1));
  if (does == "works") {
    volatile bool goesOn = true;
    while (goesOn) {
    }
  }
  if (does == "eats") {
    std::vector<std::vector<char>> eaten;
    for (;;) eaten.emplace_back(std::size_t{16} << 20, 'x');
  }
  if (does == "saves" && argc > 2) {
    // One of two contents after the other, until it is killed.
    for (int i = 0;; ++i) core::writeFileAtomically(argv[2], std::string(200000, i % 2 ? 'a' : 'b'));
  }
  if (does == "stops halfway") {
    core::writeContainedResult("an answer");
    if (::ftruncate(3, 20) != 0) return 8;
  }
  if (does == "writes rubbish") {
    if (::write(3, "rubbish, and more of it", 23) != 23) return 8;
  }
  if (does == "says too much") {
    if (::ftruncate(3, std::int64_t{2} << 30) != 0) return 8;
  }
  return 0;
}
