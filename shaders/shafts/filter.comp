#include "shafts/filter.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba16f) writeonly uniform image2D filtered;

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (all(lessThan(texel, imageSize(filtered)))) imageStore(filtered, texel, meanOfNeighbours(texel));
}
