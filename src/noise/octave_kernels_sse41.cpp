// Compiled for SSE4.1 (cmake/SkydropRowKernels.cmake); empty where the compiler has no such target.
#ifdef SKYDROP_BUILD_ROW_KERNELS
#define SKYDROP_OCTAVE_KERNELS kOctaveKernelsSse41
#include "noise/octave_kernels.inl"
#endif
