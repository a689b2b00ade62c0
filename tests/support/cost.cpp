#include "support/cost.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>

namespace skydrop::test {
namespace {

long residentKiB(int who) {
  rusage usage{};
  getrusage(who, &usage);
  return usage.ru_maxrss;
}

}  // namespace

Cost costOf(const std::function<bool()>& action, int mostCpuSeconds) {
  const long before = residentKiB(RUSAGE_SELF);
  const pid_t child = fork();
  if (child == 0) {
    const auto seconds = static_cast<rlim_t>(mostCpuSeconds);
    const rlimit limit{seconds, seconds};
    setrlimit(RLIMIT_CPU, &limit);
    bool good = false;
    try {
      good = action();
    } catch (...) {
    }
    _exit(good ? 0 : 1);
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
  };
  return {WIFEXITED(status) && WEXITSTATUS(status) == 0, seconds(usage.ru_utime) + seconds(usage.ru_stime),
          std::max(0L, usage.ru_maxrss - before) / 1024};
}

}  // namespace skydrop::test
