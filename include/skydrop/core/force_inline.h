// Inlining that is not a hint. Row kernels are compiled once for each instruction set: an inline function of
// a header that is left as a call there could be the one copy that the linker keeps for the whole program.
#pragma once

#if defined(__GNUC__)
#define SKYDROP_INLINE __attribute__((always_inline)) inline
#define SKYDROP_INLINE_LAMBDA __attribute__((always_inline))
#elif defined(_MSC_VER)
#define SKYDROP_INLINE __forceinline
#define SKYDROP_INLINE_LAMBDA
#else
#define SKYDROP_INLINE inline
#define SKYDROP_INLINE_LAMBDA
#endif
