// Compiled for AVX2 (cmake/SkydropRowKernels.cmake); empty where the compiler has no such target.
#ifdef SKYDROP_BUILD_ROW_KERNELS
#define SKYDROP_SURFACE_KERNELS kSurfaceKernelsAvx2
#include "elevation/surface_kernels.inl"
#endif
