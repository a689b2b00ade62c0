// CPU time that a thread has used since the clock's construction: what else the machine does counts little.
#pragma once

namespace skydrop::core {

// Asking costs a system call, 0.2 to 1 us. A value; made and asked on one thread.
class CpuClock {
 public:
  CpuClock() : begin_(ofThisThreadMs()) {}
  double ms() const { return ofThisThreadMs() - begin_; }

 private:
  // Of the calling thread since it began, to 1 ns on POSIX (CLOCK_THREAD_CPUTIME_ID), to 16 ms on Windows.
  static double ofThisThreadMs();

  double begin_;
};

}  // namespace skydrop::core
