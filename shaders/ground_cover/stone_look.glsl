// A fragment of a stone: facets, grain, and dirt towards the ground.
#include "frame.glsl"
#include "shared/lattice_noise.glsl"

struct StoneLight {
  vec3 sun, above, below, air;
};

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
  vec3 grey = mix(vec3(0.13, 0.122, 0.112), vec3(0.31, 0.29, 0.255), own.x);
  vec3 albedo = mix(grey, ground, 0.25) * (1.0 + 0.28 * grain.w);
  float up = 0.5 + 0.5 * normal.y;
  float open = 0.6 + 0.4 * smoothstep(-0.05, 0.18, relative.y - own.z);  // the ground hides the sky from its foot
  vec3 lit = light.sun * max(dot(normal, frame.toSun.xyz), 0.0) + mix(light.below, light.above, up) * open;
  return albedo * lit + light.air;
}
