// The rays of the listed tiles, RAY_SPACING pixels apart. GROUP_SIZE: invocations of a group, those of one tile or of four.
#include "clouds/tile_list.glsl"

// Whether an invocation has a ray, of a picture of such a size, and which.
bool rayOfTile(uint group, uint invocation, ivec2 size, out ivec2 texel) {
  const uint side = uint(TILE_SIDE / RAY_SPACING);
  uint ray = group * uint(GROUP_SIZE) + invocation;
  uint index = ray / (side * side);
  texel = ivec2(0);
  if (index >= tiles.groups.w) return false;
  texel = taskPlace(tiles.tasks[index]) * int(side) + placeInSquare(ray % (side * side), side);
  return all(lessThan(texel, size));
}
