#include "shafts/compose.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba16f) uniform image2D scene;

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, viewSize()))) return;
  vec4 before = imageLoad(scene, pixel);
  imageStore(scene, pixel, vec4(withoutLoss(before.xyz, lossOf(pixel)), before.w));
}
