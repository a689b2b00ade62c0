#include "app/measure/system_info.h"

#ifdef __linux__
#include <unistd.h>
#endif

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

namespace skydrop::app {
namespace {

// How long this process has been running, by /proc; 0 where there is none.
double secondsBeforeFirstUse() {
#ifdef __linux__
  std::ifstream stat("/proc/self/stat"), uptime("/proc/uptime");
  std::string line;
  double up = 0;
  if (!std::getline(stat, line) || !(uptime >> up)) return 0;
  // The name in parentheses may hold spaces; the start, in clock ticks after boot, is the 20th word behind
  // it.
  std::istringstream words(line.substr(line.rfind(')') + 1));
  std::string word;
  for (int i = 0; i < 20; ++i) words >> word;
  const double started = std::strtod(word.c_str(), nullptr) / static_cast<double>(sysconf(_SC_CLK_TCK));
  return up > started ? up - started : 0;
#else
  return 0;
#endif
}

}  // namespace

std::string machineName() {
  std::string name = "unknown processor";
  std::ifstream cpuInfo("/proc/cpuinfo");
  for (std::string line; std::getline(cpuInfo, line);) {
    if (!line.starts_with("model name")) continue;
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos) name = line.substr(colon + 2);
    break;
  }
  return name + ", " + std::to_string(std::thread::hardware_concurrency()) + " threads";
}

double secondsSinceStart() {
  using Clock = std::chrono::steady_clock;
  // steady_clock does not count the time that the machine slept, /proc does: read once, in the first call.
  static const Clock::time_point kFirst = Clock::now();
  static const double kBefore = secondsBeforeFirstUse();
  return kBefore + std::chrono::duration<double>(Clock::now() - kFirst).count();
}

}  // namespace skydrop::app
