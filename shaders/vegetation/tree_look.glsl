// A fragment of a tree's mesh near by.
#include "vegetation/lit_tree.glsl"
#include "vegetation/leaves.glsl"

// rim: from the shape's normal, before leaves roughen it; toEye: unit.
vec3 treeColor(TreeLight light, vec3 normal, vec2 open, float bark, Leaves leaves) {
  vec3 rough = normalize(normal - leaves.slope);
  return treeRadiance(TreeLight(light.sun, light.above, light.below, vec3(0.0)), rough, open.x, open.y,
                      mix(vec3(1.0), kBarkHue, bark)) * max(leaves.shade, 0.15) + light.air;
}

float rimOf(vec3 normal, vec3 relative) { return 1.0 - abs(dot(normalize(normal), normalize(relative))); }
