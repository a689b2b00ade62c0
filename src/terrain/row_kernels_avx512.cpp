// Compiled for AVX-512 (cmake/SkydropRowKernels.cmake); empty where the compiler has no such target.
#ifdef SKYDROP_BUILD_ROW_KERNELS
#define SKYDROP_ROW_KERNELS kRowKernelsAvx512
#include "terrain/row_kernels.inl"
#endif
