// The ground below the sea at a place, from the heights that the land is drawn with.
#include "terrain/surface.glsl"

layout(binding = 2) uniform usampler2D chunkTable;  // layers by level and place, as in terrain/land.glsl
const uint kNoChunk = 0xffffu;

#include "terrain/drawn_height.glsl"

const float kUnknownFloorM = 1e3;

struct SeaFloor {
  float depthM;
  vec2 fall;  // how it grows, per metre along x and z
};

// On the mesh at the place's level of detail, without the morph to the next (a few centimetres near the shore).
SeaFloor seaFloorAt(vec2 place, float distanceM) {
  int level = int(lodLambda(distanceM, lodMorph));
  vec2 samples = place / kCellMetres;
  ivec2 number = baseChunk * kChunkCells + ivec2(floor(samples));
  int stride = 1 << level;
  ivec2 corner = (number >> level) << level;
  vec2 inside = (vec2(number - corner) + samples - floor(samples)) / float(stride);
  float nw = storedHeightAt(corner, level), ne = storedHeightAt(corner + ivec2(stride, 0), level);
  float sw = storedHeightAt(corner + ivec2(0, stride), level), se = storedHeightAt(corner + ivec2(stride), level);
  SeaFloor ground;
  ground.depthM = min(-meshHeight(nw, ne, sw, se, inside.x, inside.y), kUnknownFloorM);
  ground.fall = -vec2(mix(ne - nw, se - sw, inside.y), mix(sw - nw, se - ne, inside.x)) / (kCellMetres * float(stride));
  return ground;
}
