// Compiled for SSE4.1 (cmake/SkydropRowKernels.cmake); empty where the compiler has no such target.
#ifdef SKYDROP_BUILD_ROW_KERNELS
#define SKYDROP_SURFACE_KERNELS kSurfaceKernelsSse41
#include "elevation/surface_kernels.inl"
#endif
