#include "skydrop/core/instruction_set.h"

#if defined(_MSC_VER) && defined(_M_X64)
#include <immintrin.h>
#include <intrin.h>
#endif

namespace skydrop::core {

#if defined(_MSC_VER) && defined(_M_X64)
bool supports(InstructionSet set) {
  int leaf1[4], leaf7[4];
  __cpuid(leaf1, 1);
  __cpuidex(leaf7, 7, 0);
  const auto has = [](int bits, int bit) { return (bits >> bit & 1) != 0; };
  const unsigned long long saved = has(leaf1[2], 27) ? _xgetbv(0) : 0;
  if (set == InstructionSet::baseline) return true;
  if (set == InstructionSet::sse41) return has(leaf1[2], 19);
  if (set == InstructionSet::avx2) return (saved & 0x6) == 0x6 && has(leaf7[1], 5);
  return (saved & 0xe6) == 0xe6 && has(leaf7[1], 16) && has(leaf7[1], 17) && has(leaf7[1], 30) &&
         has(leaf7[1], 31);
}
#elif defined(__x86_64__)
bool supports(InstructionSet set) {
  if (set == InstructionSet::baseline) return true;
  if (set == InstructionSet::sse41) return __builtin_cpu_supports("sse4.1") != 0;
  if (set == InstructionSet::avx2) return __builtin_cpu_supports("avx2") != 0;
  return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512vl") != 0 &&
         __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512bw") != 0;
}
#else
bool supports(InstructionSet set) { return set == InstructionSet::baseline; }
#endif

}  // namespace skydrop::core
