// Compiled for AVX2 (cmake/SkydropRowKernels.cmake); empty where the compiler has no such target.
#ifdef SKYDROP_BUILD_ROW_KERNELS
#define SKYDROP_ROW_KERNELS kRowKernelsAvx2
#include "terrain/row_kernels.inl"
#endif
