// A fragment of a tree's mesh near by.
#include "vegetation/lit_tree.glsl"
#include "vegetation/leaves.glsl"

// Of bark, where the light of the instance is that of foliage with snow on it.
const vec3 kSnowedBarkHue = vec3(0.25);

// bark: its share; snow: how much lies on the tree, [0, 1].
vec3 treeColor(TreeLight light, vec3 normal, vec2 open, float bark, float snow, Leaves leaves) {
  vec3 rough = normalize(normal - leaves.slope);
  return treeRadiance(TreeLight(light.sun, light.above, light.below, vec3(0.0)), rough, open.x, open.y,
                      mix(vec3(1.0), mix(kBarkHue, kSnowedBarkHue, snow), bark)) * max(leaves.shade, 0.15) + light.air;
}

// From the shape's normal, before leaves roughen it.
float rimOf(vec3 normal, vec3 relative) { return 1.0 - abs(dot(normalize(normal), normalize(relative))); }
