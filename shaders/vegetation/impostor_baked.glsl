// What a texel of the atlas keeps: normal times the share of light that is left, premultiplied (0.5 is none), and coverage.
#include "vegetation/leaves.glsl"

uniform vec4 bakeShape;
uniform vec3 bakeTowards;

vec4 bakedTexel(vec3 unitPlace, vec3 normal, vec2 surface) {
  float rim = 1.0 - abs(dot(normalize(normal), bakeTowards));
  Leaves leaves = leavesAt(unitPlace, bakeShape.z, surface.y, rim);
  if (leaves.opaque < 0.0) return vec4(0.0);
  float left = mix(0.55, 1.0, surface.x) * clamp(leaves.shade, 0.15, 1.6) * kBakedLight * mix(1.0, 1.3, surface.y);
  return vec4(normalize(normalize(normal) - leaves.slope) * (min(left, 1.0) * 0.5) + 0.5, 1.0);
}
