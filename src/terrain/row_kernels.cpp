#include "terrain/row_kernels.h"

#if defined(SKYDROP_WIDE_ROW_KERNELS) && defined(_MSC_VER)
#include <immintrin.h>
#include <intrin.h>
#endif

namespace skydrop::terrain {

extern const RowKernels kRowKernelsBaseline;

#ifdef SKYDROP_WIDE_ROW_KERNELS
extern const RowKernels kRowKernelsSse41, kRowKernelsAvx2, kRowKernelsAvx512;

namespace {

// Whether processor and system support the set. avx512 means what the build names: F, VL, DQ and BW.
#if defined(_MSC_VER)
bool supports(InstructionSet set) {
  int leaf1[4], leaf7[4];
  __cpuid(leaf1, 1);
  __cpuidex(leaf7, 7, 0);
  const auto has = [](int bits, int bit) { return (bits >> bit & 1) != 0; };
  const unsigned long long saved = has(leaf1[2], 27) ? _xgetbv(0) : 0;
  if (set == InstructionSet::sse41) return has(leaf1[2], 19);
  if (set == InstructionSet::avx2) return (saved & 0x6) == 0x6 && has(leaf7[1], 5);
  return (saved & 0xe6) == 0xe6 && has(leaf7[1], 16) && has(leaf7[1], 17) && has(leaf7[1], 30) &&
         has(leaf7[1], 31);
}
#else
bool supports(InstructionSet set) {
  if (set == InstructionSet::sse41) return __builtin_cpu_supports("sse4.1") != 0;
  if (set == InstructionSet::avx2) return __builtin_cpu_supports("avx2") != 0;
  return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512vl") != 0 &&
         __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512bw") != 0;
}
#endif

}  // namespace

const RowKernels* rowKernels(InstructionSet set) {
  if (set == InstructionSet::baseline) return &kRowKernelsBaseline;
  if (!supports(set)) return nullptr;
  if (set == InstructionSet::sse41) return &kRowKernelsSse41;
  return set == InstructionSet::avx2 ? &kRowKernelsAvx2 : &kRowKernelsAvx512;
}
#else
const RowKernels* rowKernels(InstructionSet set) {
  return set == InstructionSet::baseline ? &kRowKernelsBaseline : nullptr;
}
#endif

const RowKernels& bestRowKernels() {
  static const RowKernels* const best = [] {
    const RowKernels* widest = &kRowKernelsBaseline;
    for (const InstructionSet set : kInstructionSets) {
      if (const RowKernels* kernels = rowKernels(set)) widest = kernels;
    }
    return widest;
  }();
  return *best;
}

}  // namespace skydrop::terrain
