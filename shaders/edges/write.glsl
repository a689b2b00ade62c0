// Puts the listed pixels' light into the scene. What the alpha was for is past.
#include "edges/lists.glsl"
#include "edges/lights.glsl"

layout(binding = 0, rgba16f) uniform writeonly image2D scene;

void writeListed(uint index) {
  if (index >= listedPixels.groups.w) return;
  ivec2 pixel = pixelInList(index);
  imageStore(scene, pixel, vec4(takeLight(index, pixel), 1.0));
}
