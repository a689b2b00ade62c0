// Marches the rays of the listed tiles, RAY_SPACING pixels apart. GROUP_SIZE: invocations of a group, those of one tile or of
// four.
#include "clouds/march_ray.glsl"

layout(std430, binding = 0) readonly buffer Tiles {
  uvec4 groups;
  uvec4 groupsOfFour;
  Task tasks[];
} tiles;

void marchTile(uint group, uint invocation) {
  const uint side = uint(TILE_SIDE / RAY_SPACING);
  uint ray = group * uint(GROUP_SIZE) + invocation;
  uint index = ray / (side * side);
  if (index >= tiles.groups.w) return;
  ivec2 texel = taskPlace(tiles.tasks[index]) * int(side) + placeInSquare(ray % (side * side), side);
  if (all(lessThan(texel, imageSize(light)))) marchRayOf(texel);
}
