#include "edges/mark.glsl"

// A software renderer runs neighbours in x together.
layout(local_size_x = 8) in;

void main() {
  ivec2 block = ivec2(gl_GlobalInvocationID.yx);
  if (block.x >= tiles.x || block.y >= tiles.y * (32 / kRows)) return;
  markBlock(block);
}
