// Puts the listed pixels' light into the scene, and clears their shares for the next frame.
#include "edges/lists.glsl"
#include "edges/lights.glsl"
#include "edges/shares.glsl"

layout(binding = 0, rgba16f) uniform writeonly image2D scene;

void writeListed(uint index) {
  if (index >= listedPixels.groups.w) return;
  imageStore(scene, pixelInList(index), keptLight(index));
  imageStore(shares, pixelInList(index), uvec4(0u));
}
