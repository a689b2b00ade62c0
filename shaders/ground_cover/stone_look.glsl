// A fragment of a stone: facets, grain, and dirt towards the ground.
#include "frame.glsl"
#include "shared/lattice_noise.glsl"
#include "ground_cover/stone_light.glsl"

vec3 facetOf(vec3 relative) {
  vec3 normal = cross(dFdx(relative), dFdy(relative));
  float l = length(normal);
  normal = l > 1e-20 ? normal / l : vec3(0.0, 1.0, 0.0);
  return dot(normal, relative) > 0.0 ? -normal : normal;
}

// own: tint, bits, height of the ground relative to the eye.
vec3 stoneColor(StoneLight light, vec3 ground, vec3 relative, vec3 inStone, vec3 own) {
  uint bits = uint(own.y);
  vec4 grain = simplexNoise(uvec3(bits & 0xfffu, bits >> 12, 9u), inStone * 11.0);
  vec3 normal = normalize(facetOf(relative) - 0.045 * grain.xyz);
  return stoneLit(light, ground, normal, grain.w, own.x, relative.y - own.z);
}
