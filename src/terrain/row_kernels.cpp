#include "terrain/row_kernels.h"

namespace skydrop::terrain {

extern const RowKernels kRowKernelsBaseline;

#ifdef SKYDROP_WIDE_ROW_KERNELS
extern const RowKernels kRowKernelsSse41, kRowKernelsAvx2, kRowKernelsAvx512;

const RowKernels* rowKernels(InstructionSet set) {
  if (set == InstructionSet::baseline) return &kRowKernelsBaseline;
  if (!core::supports(set)) return nullptr;
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
