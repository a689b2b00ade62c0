// Of the rays that every listed tile has: fills those that the last frame knows and lists the others.
#include "clouds/recall_ray.glsl"
#include "clouds/tile_rays.glsl"

void recallTile(uint group, uint invocation) {
  ivec2 texel;
  bool isRay = rayOfTile(group, invocation, imageSize(light), texel);
  float guessM = isRay ? distanceAroundPast(texel * RAY_SPACING) : kFarDistance;
  recallRay(invocation, texel, isRay, false, orderInRound(texel), guessM);
}
