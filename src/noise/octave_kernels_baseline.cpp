// For every x86-64, and any other processor.
#define SKYDROP_OCTAVE_KERNELS kOctaveKernelsBaseline
#include "noise/octave_kernels.inl"
