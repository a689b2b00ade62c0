// Fills a ray with what the last frame knows of it, or lists it to be marched. ROUND: in so many frames each ray has its
// turn.
#include "clouds/past.glsl"
#include "clouds/ray_list.glsl"

layout(std430, binding = 1) readonly buffer Spans { vec2 spans[]; };
layout(binding = 0, rgba16f) uniform writeonly image2D light;
layout(binding = 1, r16f) uniform image2D distances;
layout(binding = 2, r16f) uniform writeonly image2D doubts;

// A ray of which there is more doubt is marched before its turn: measured, so that the tier high errs as much as without
// history while flying straight on.
const float kMostDoubt = 0.06;

uniform ivec2 tileCount;
uniform uint turn;  // of the frame

// Of 2 x 2 places, neighbours far apart.
uint orderOfFour(ivec2 at) { return uint(((at.x ^ at.y) & 1) * 2 + (at.y & 1)); }

// When a place has its turn: Bayer's order.
uint orderInRound(ivec2 at) { return ROUND > 4 ? orderOfFour(at) * 4u + orderOfFour(at >> 1) : orderOfFour(at); }

// End of what the tile of a pixel may hold of cloud, m.
float endOfCloud(ivec2 pixel) {
  ivec2 tile = pixel / TILE_SIDE;
  int at = (tile.y * tileCount.x + tile.x) * kPlacesOfSpans;
  return spans[at + clamp(int(spans[at].x), 1, kMostSpans)].y;
}

// A ray that may be left is filled already. All invocations of a group call it, those that have a ray (isRay) and those that
// have none.
void recallRay(uint invocation, ivec2 texel, bool isRay, bool mayBeLeft, uint order, float guessM) {
  bool isDue = (order & uint(ROUND - 1)) == (turn & uint(ROUND - 1));
  ivec2 pixel = texel * RAY_SPACING;
  Past known = isRay ? pastOf(pixel, guessM, endOfCloud(pixel)) : unknownPast();
  // Beyond the picture's edge nothing is kept.
  bool isWithin = all(lessThan(pixel, viewSize()));
  bool canWait = known.isKnown || (mayBeLeft && isWithin);
  bool isListed = isRay && (isDue || !canWait || known.doubt > kMostDoubt);
  if (isRay && !isListed && known.isKnown) {
    imageStore(light, texel, known.seen);
    imageStore(distances, texel, vec4(known.distanceM));
    imageStore(doubts, pixel, vec4(known.doubt));
  }
  uint at = placesInList(invocation, isListed ? 1u : 0u);
  if (isListed) rays.texels[at] = packedPlace(texel);
}
