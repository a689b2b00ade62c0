// What rays of tiles see that are not listed: nothing. Every texel of the pictures of rays is one of a tile's.
#include "clouds/tiles.glsl"
#include "shared/half_float.glsl"

layout(std430, binding = 1) readonly buffer Spans { vec2 spans[]; };
layout(binding = 0, rgba16f) uniform writeonly image2D light;
layout(binding = 1, r16f) uniform writeonly image2D distances;

uniform int raySpacing;  // pixels

void clearTile(ivec2 tile, ivec2 tileCount, uint invocation) {
  if (spans[(tile.y * tileCount.x + tile.x) * kPlacesOfSpans].x > 0.0) return;
  uint side = uint(TILE_SIDE / raySpacing);
  ivec2 size = imageSize(light);
  for (uint i = invocation; i < side * side; i += 64u) {
    ivec2 texel = tile * int(side) + ivec2(i % side, i / side);
    if (texel.x >= size.x || texel.y >= size.y) continue;
    imageStore(light, texel, vec4(0.0, 0.0, 0.0, 1.0));
    imageStore(distances, texel, vec4(kFarDistance));
  }
}
