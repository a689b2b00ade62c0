#include "water/mirror.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba16f) uniform writeonly image2D mirroredOut;

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(texel, imageSize(mirroredOut)))) return;
  ivec2 pixel = min(texel * spacing + spacing / 2, ivec2(frame.viewport.xy) - 1);
  imageStore(mirroredOut, texel, mirroredScene(pixel));
}
