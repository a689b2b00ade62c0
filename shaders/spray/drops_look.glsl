// How drops look: a tuft tears into grains the older it is.
#include "frame.glsl"
#include "shared/lattice_noise.glsl"
#include "spray/seen.glsl"

float grains(vec2 place) {
  vec2 cell = floor(place);
  return latticeNoise(uvec2(ivec2(cell)), place - cell).x;
}

float tuftCover(vec2 corner, vec4 look, vec2 shape) {
  float square = dot(corner, corner);
  vec2 at = corner * vec2(1.0, shape.x) * 2.1 + vec2(53.0, 19.0) * (1.0 + 100.0 * look.y);
  float noise = 0.8 * grains(at) + 0.6 * grains(at * 2.7);
  // Grains of less than a pixel are their mean.
  float shown = saturate(0.25 * shape.y - 0.5);
  float torn = mix(0.15, 0.75, look.w);
  float ragged = smoothstep(torn - 0.25, torn + 0.25, 0.62 + noise * 1.1 * shown - 0.35 * square);
  return ragged * saturate(2.5 * (1.0 - square));
}

vec4 tuftSeen(vec2 corner, vec4 look, vec2 shape, vec3 light, float distanceM) {
  float opacity = look.x * tuftCover(corner, look, shape) * shareBefore(look.z, 0.15) * throughClouds(distanceM);
  return vec4(min(light, vec3(kBrightest)) * opacity, opacity);
}
