// Lays clouds over the scene.
#include "frame.glsl"

layout(binding = 0, rgba16f) uniform image2D scene;

// cloud: radiance, and what comes through of the scene's.
void cover(ivec2 pixel, vec4 cloud) {
  vec4 before = imageLoad(scene, pixel);
  vec3 light = min(before.xyz * cloud.w + cloud.xyz, vec3(kBrightest));
  imageStore(scene, pixel, vec4(light, before.w));
}
