// What an action costs at most: processor time and memory, measured in a child process.
#pragma once

#include <functional>

namespace skydrop::test {

struct Cost {
  bool isDone = false;  // the action returned true, within the time
  double cpuSeconds = 0;
  long moreMiB = 0;  // resident memory at its peak, beyond what the parent had
};

// Runs the action in a fork that the system ends after so much processor time, so a test of work that must
// stay bounded neither waits nor depends on what else the machine does.
Cost costOf(const std::function<bool()>& action, int mostCpuSeconds);

}  // namespace skydrop::test
