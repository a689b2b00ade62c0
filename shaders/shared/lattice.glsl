// What the noises on integer lattices have in common, in scalars alone: the row kernels of src/noise compile this file
// once for each instruction set, and so the same bits come from them, from plain C++ and from GLSL.
#ifndef __cplusplus
#include "shared/dialect.glsl"
#endif

// The last rounds of lowbias32 (Wellons, "Prospecting for Hash Functions", 2018) over the sum of both coordinates'
// products: half of the work of hash2, which matters in a shader that runs it sixteen times a pixel.
FN Uint latticeBits(Uint column, Uint row) {
  Uint bits = column + row;
  bits = bits ^ (bits >> Uint(16u));
  bits = bits * Uint(0x7feb352du);
  bits = bits ^ (bits >> Uint(15u));
  bits = bits * Uint(0x846ca68bu);
  return bits ^ (bits >> Uint(16u));
}

FN Real smoothStep5(Real t) { return t * t * t * (t * (t * Real(6.0) - Real(15.0)) + Real(10.0)); }

// a at t = 0, b at t = 1; the same operations wherever it is compiled, which mix() does not promise.
FN Real blend(Real a, Real b, Real t) { return a + t * (b - a); }
