#include "noise/octave_kernels.h"

namespace skydrop::noise {

extern const OctaveKernels kOctaveKernelsBaseline;

#ifdef SKYDROP_WIDE_ROW_KERNELS
extern const OctaveKernels kOctaveKernelsSse41, kOctaveKernelsAvx2, kOctaveKernelsAvx512;

const OctaveKernels* octaveKernels(InstructionSet set) {
  if (!core::supports(set)) return nullptr;
  switch (set) {
    case InstructionSet::baseline:
      return &kOctaveKernelsBaseline;
    case InstructionSet::sse41:
      return &kOctaveKernelsSse41;
    case InstructionSet::avx2:
      return &kOctaveKernelsAvx2;
    case InstructionSet::avx512:
      return &kOctaveKernelsAvx512;
  }
  return nullptr;
}
#else
const OctaveKernels* octaveKernels(InstructionSet set) {
  return set == InstructionSet::baseline ? &kOctaveKernelsBaseline : nullptr;
}
#endif

const OctaveKernels& bestOctaveKernels() {
  static const OctaveKernels* const best = [] {
    const OctaveKernels* widest = &kOctaveKernelsBaseline;
    for (const InstructionSet set : core::kInstructionSets) {
      if (const OctaveKernels* kernels = octaveKernels(set)) widest = kernels;
    }
    return widest;
  }();
  return *best;
}

}  // namespace skydrop::noise
