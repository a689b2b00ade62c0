#include "water/compose.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba16f) uniform image2D scene;

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, ivec2(frame.viewport.xy))) || !mirrorsAt(pixel)) return;
  vec4 light = imageLoad(scene, pixel);
  imageStore(scene, pixel, vec4(max(light.rgb + mirroredLight(pixel), vec3(0.0)), light.a));
}
