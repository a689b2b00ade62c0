// Of the rays that every listed tile has, RAY_SPACING pixels apart: fills those that the last frame knows and lists the others.
// GROUP_SIZE: invocations of a group, those of one tile or of four.
#include "clouds/recall_ray.glsl"

layout(std430, binding = 0) readonly buffer Tiles {
  uvec4 groups;
  uvec4 groupsOfFour;
  Task tasks[];
} tiles;

void recallTile(uint group, uint invocation) {
  const uint side = uint(TILE_SIDE / RAY_SPACING);
  uint ray = group * uint(GROUP_SIZE) + invocation;
  uint index = ray / (side * side);
  bool isRay = index < tiles.groups.w;
  ivec2 texel = ivec2(0);
  if (isRay) texel = taskPlace(tiles.tasks[index]) * int(side) + placeInSquare(ray % (side * side), side);
  isRay = isRay && all(lessThan(texel, imageSize(light)));
  float guessM = isRay ? distanceAroundPast(texel * RAY_SPACING) : kFarDistance;
  recallRay(invocation, texel, isRay, false, orderInRound(texel), guessM);
}
