// For every x86-64, and any other processor.
#define SKYDROP_ROW_KERNELS kRowKernelsBaseline
#include "terrain/row_kernels.inl"
