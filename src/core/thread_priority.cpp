#include "skydrop/core/thread_priority.h"

#if defined(__linux__)
#include <sys/resource.h>
#elif defined(_WIN32)
#include <windows.h>
#endif

namespace skydrop::core {

void lowerThreadPriority() {
#if defined(__linux__)
  constexpr int kNice = 3;  // with 10, a drawing software renderer held a chunk up for five frames
  setpriority(PRIO_PROCESS, 0, kNice);  // on Linux 0 means the calling thread, not the process
#elif defined(_WIN32)
  SetThreadPriority(GetCurrentThread(), THREAD_PRIORITY_BELOW_NORMAL);
#endif
}

}  // namespace skydrop::core
