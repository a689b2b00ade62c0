#include "elevation/surface_kernels.h"

namespace skydrop::elevation {

extern const SurfaceKernels kSurfaceKernelsBaseline;

#ifdef SKYDROP_WIDE_ROW_KERNELS
extern const SurfaceKernels kSurfaceKernelsSse41, kSurfaceKernelsAvx2, kSurfaceKernelsAvx512;

const SurfaceKernels* surfaceKernels(core::InstructionSet set) {
  if (!core::supports(set)) return nullptr;
  switch (set) {
    case core::InstructionSet::baseline:
      return &kSurfaceKernelsBaseline;
    case core::InstructionSet::sse41:
      return &kSurfaceKernelsSse41;
    case core::InstructionSet::avx2:
      return &kSurfaceKernelsAvx2;
    case core::InstructionSet::avx512:
      return &kSurfaceKernelsAvx512;
  }
  return nullptr;
}
#else
const SurfaceKernels* surfaceKernels(core::InstructionSet set) {
  return set == core::InstructionSet::baseline ? &kSurfaceKernelsBaseline : nullptr;
}
#endif

const SurfaceKernels& bestSurfaceKernels() {
  static const SurfaceKernels* const best = [] {
    const SurfaceKernels* widest = &kSurfaceKernelsBaseline;
    for (const core::InstructionSet set : core::kInstructionSets) {
      if (const SurfaceKernels* kernels = surfaceKernels(set)) widest = kernels;
    }
    return widest;
  }();
  return *best;
}

}  // namespace skydrop::elevation
