// Compiled for AVX2 (cmake/SkydropRowKernels.cmake); empty where the compiler has no such target.
#ifdef SKYDROP_BUILD_ROW_KERNELS
#define SKYDROP_OCTAVE_KERNELS kOctaveKernelsAvx2
#include "noise/octave_kernels.inl"
#endif
