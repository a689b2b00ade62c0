// Integer hashes of lattice points: the same bits in GLSL and C++, no period in reach.
// Source: pcg2d and pcg3d of Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020.
#ifndef __cplusplus
#include "shared/dialect.glsl"
#endif

FN Uvec2 hash2(Uvec2 v) {
  v = v * Uint(1664525u) + Uvec2(1013904223u, 1013904223u);
  v.x += v.y * Uint(1664525u);
  v.y += v.x * Uint(1664525u);
  v = v ^ (v >> Uint(16u));
  v.x += v.y * Uint(1664525u);
  v.y += v.x * Uint(1664525u);
  v = v ^ (v >> Uint(16u));
  return v;
}

FN Uvec3 hash3(Uvec3 v) {
  v = v * Uint(1664525u) + Uvec3(1013904223u, 1013904223u, 1013904223u);
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v = v ^ (v >> Uint(16u));
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  return v;
}

// Uniform in [0, 1): the upper 24 bits, exact in float.
FN Real unitOf(Uint bits) { return Real(bits >> Uint(8u)) * Real(5.9604644775390625e-8); }
