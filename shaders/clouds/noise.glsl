// Fills slices of a noise texture, a packed texel (red lowest) to a word. One of SHAPE, DETAIL and WEATHER is defined.
#include "shared/cloud_noise.glsl"

layout(std430, binding = 0) writeonly buffer Texels { uint texels[]; };

uniform uint seed;
uniform uint side;        // texels
uniform uint firstSlice;  // a layer of a volume, a row of a map

#if defined(SHAPE)
vec4 noiseAt(vec3 place) { return cloudShapeNoise(place, seed); }
#elif defined(DETAIL)
vec4 noiseAt(vec3 place) { return cloudDetailNoise(place, seed); }
#else
vec4 noiseAt(vec3 place) { return cloudWeatherNoise(place.xy, seed); }
#endif

uint packedTexel(vec4 value) {
  uvec4 bytes = uvec4(clamp(value, 0.0, 1.0) * 255.0 + 0.5);
  return bytes.x | bytes.y << 8u | bytes.z << 16u | bytes.w << 24u;
}

// Invocations run along x, y and the slices of a volume, or along x and the slices of a map.
void fillTexel(uvec3 at) {
  uvec3 texel = at + uvec3(0u, 0u, firstSlice);
#ifdef WEATHER
  texel.y += firstSlice;
#endif
  if (texel.x >= side || texel.y >= side || texel.z >= side) return;
  vec3 place = (vec3(texel) + 0.5) / float(side);
#ifdef WEATHER
  texels[texel.y * side + texel.x] = packedTexel(noiseAt(place));
#else
  texels[(texel.z * side + texel.y) * side + texel.x] = packedTexel(noiseAt(place));
#endif
}
