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
  MeshCell cell = meshCellAt(place, level);
  SeaFloor ground;
  ground.depthM = min(-meshHeight(cell.nw, cell.ne, cell.sw, cell.se, cell.inside.x, cell.inside.y), kUnknownFloorM);
  ground.fall = -vec2(mix(cell.ne - cell.nw, cell.se - cell.sw, cell.inside.y),
                      mix(cell.sw - cell.nw, cell.se - cell.ne, cell.inside.x)) / cell.cellM;
  return ground;
}
