// For every x86-64, and any other processor.
#define SKYDROP_SURFACE_KERNELS kSurfaceKernelsBaseline
#include "elevation/surface_kernels.inl"
