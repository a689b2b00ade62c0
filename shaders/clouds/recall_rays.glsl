// Of the rays that shaders/clouds/refine.glsl has listed: fills those that the last frame knows and lists the others.
#include "clouds/recall_ray.glsl"

layout(std430, binding = 4) readonly buffer Candidates {
  uvec4 groups;
  uint texels[];
} candidates;

void recallListed(uint group, uint invocation) {
  uint index = group * 64u + invocation;
  bool isRay = index < candidates.groups.w;
  uint place = isRay ? candidates.texels[index] : 0u;
  ivec2 texel = unpackedPlace(place & ~kMayBeLeft);
  isRay = isRay && all(lessThan(texel, imageSize(light)));
  float guessM = isRay ? imageLoad(distances, texel).x : kFarDistance;
  // The three rays of a cell take turns too.
  uint inCell = uint((texel.x & 1) + 2 * (texel.y & 1) - 1);
  uint order = orderInRound(texel >> 1) + inCell * (uint(ROUND) / 4u + 1u);
  recallRay(invocation, texel, isRay, (place & kMayBeLeft) != 0u, order, guessM);
}
