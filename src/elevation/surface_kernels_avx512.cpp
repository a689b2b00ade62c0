// Compiled for AVX-512 (cmake/SkydropRowKernels.cmake); empty where the compiler has no such target.
#ifdef SKYDROP_BUILD_ROW_KERNELS
#define SKYDROP_SURFACE_KERNELS kSurfaceKernelsAvx512
#include "elevation/surface_kernels.inl"
#endif
