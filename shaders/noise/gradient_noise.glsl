// Fills slices of a noise texture with values in [0, 1]: layers of a volume (VOLUME is defined) or rows of a plane.
#include "shared/gradient_noise.glsl"

layout(std430, binding = 0) writeonly buffer Values { float values[]; };

uniform ivec3 size;      // texels; 1 layer of a plane
uniform vec3 halfTexel;  // 1 / (2 size)
uniform int firstSlice;
uniform ivec3 end;       // size, but for the slices of a later call
uniform uint seed;
uniform uint octaves;
uniform uint frequency;
uniform float amplitude;
uniform float persistence;

#ifdef VOLUME
const uvec3 kSliceAxis = uvec3(0u, 0u, 1u);
float valueAt(uvec3 texel) {
  return octaveNoise3(texel, uvec3(size), halfTexel, seed, octaves, frequency, amplitude, persistence);
}
#else
const uvec3 kSliceAxis = uvec3(0u, 1u, 0u);
float valueAt(uvec3 texel) {
  return octaveNoise2(texel.xy, uvec2(size.xy), halfTexel.xy, seed, octaves, frequency, amplitude, persistence);
}
#endif

void fillValue(uvec3 at) {
  uvec3 texel = at + kSliceAxis * uint(firstSlice);
  if (any(greaterThanEqual(texel, uvec3(end)))) return;
  values[(texel.z * uint(size.y) + texel.y) * uint(size.x) + texel.x] = valueAt(texel);
}
