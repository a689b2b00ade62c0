// What this process holds of the system. Linux.
#pragma once

#include <malloc.h>
#include <unistd.h>

#include <cstddef>
#include <fstream>

namespace skydrop::test {

// Bytes that are allocated and not freed.
inline std::size_t heapBytes() {
  const auto counts = mallinfo2();
  return counts.uordblks + counts.hblkhd;
}

// Bytes of memory that are resident, without what the allocator keeps of what was freed: how much that is
// hangs on which threads happened to run at once.
inline std::size_t residentBytes() {
  malloc_trim(0);
  std::ifstream statm("/proc/self/statm");
  std::size_t total = 0, resident = 0;
  statm >> total >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace skydrop::test
