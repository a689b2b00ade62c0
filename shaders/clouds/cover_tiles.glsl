// Lays the clouds over the scene, for the tiles that were marched.
#include "clouds/cover.glsl"
#include "clouds/tile_list.glsl"
#include "clouds/view.glsl"

layout(binding = 7) uniform sampler2D light;

void coverTile(uint index, uint invocation) {
  if (index >= tiles.groups.w) return;
  ivec2 corner = taskPlace(tiles.tasks[index]) * TILE_SIDE;
  ivec2 size = viewSize();
  for (uint i = invocation; i < uint(TILE_SIDE * TILE_SIDE); i += 64u) {
    ivec2 pixel = corner + placeInSquare(i, uint(TILE_SIDE));
    if (pixel.x < size.x && pixel.y < size.y) cover(pixel, texelFetch(light, pixel, 0));
  }
}
