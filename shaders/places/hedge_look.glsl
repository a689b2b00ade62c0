// A fragment of a hedge: clumps of leaves by noise in space.
#include "places/lit_place.glsl"
#include "shared/lattice_noise.glsl"

vec3 hedgeColor(vec3 place, vec3 normal, float open, float bits, PlaceLight light) {
  vec4 noise = simplexNoise(uvec3(uint(bits)), place * 2.1);
  vec3 rough = normalize(normal - 0.45 * noise.xyz * 0.5);
  float own = fract(bits * 0.0173);
  vec3 albedo = mix(vec3(0.024, 0.044, 0.013), vec3(0.048, 0.070, 0.020), own) * max(1.0 + 0.8 * noise.w, 0.2);
  return placeRadiance(light, albedo, rough, open, mix(0.6, 1.0, open));
}
