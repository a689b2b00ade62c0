// Which tiles have to be marched, and between which distances. A tile's rays are judged together: as one wide ray.
#include "clouds/occupancy.glsl"
#include "clouds/view.glsl"
#include "clouds/tiles.glsl"

layout(std430, binding = 0) buffer Tiles {
  uvec4 groups;  // of the march's dispatch; w: tiles in the list
  Task tasks[];
} tiles;

// Where any ray of a cone may lie in the layer; `width` is the cone's half-width at 1 m.
RaySpan layerOfCone(float directionY, float width) {
  RaySpan aboveBase = raySpanBetween(0.0, directionY + width, clouds.layer.x, 1e30);
  RaySpan belowTop = raySpanBetween(0.0, directionY - width, -1e30, clouds.layer.x + clouds.layer.y);
  return overlap(overlap(aboveBase, belowTop), make_raySpan(0.0, clouds.layer.z));
}

// The part of a cone's interval in which it touches occupied cells; conservative.
RaySpan occupiedSpan(vec3 direction, float width, RaySpan span) {
  CellRay ray = cellRay(direction);
  vec3 cellsAMetre = clouds.cells.ywy;
  float pace = 0.5 / max(cellsAMetre.x, cellsAMetre.y);
  RaySpan found = make_raySpan(span.end, span.begin);
  float at = span.begin;
  while (at < span.end) {
    vec3 place = ray.start + ray.perLength * at;
    float cells = emptyCells(ivec3(floor(place)));
    float way = wayOutOfBox(place, ray.perLength, cells, cellsAMetre * (width * at), cellsAMetre * width);
    float step = max(pace, width * at);
    bool leaps = cells >= 1.0 && way > 0.1 * step;
    found.begin = leaps ? found.begin : min(found.begin, at);
    at += leaps ? way : step;
    found.end = leaps ? found.end : at;
  }
  return make_raySpan(found.begin, min(found.end, span.end));
}

void classifyTile(ivec2 tile, ivec2 tileCount) {
  if (tile.x >= tileCount.x || tile.y >= tileCount.y) return;
  int side = kTileSide * DIVISOR;
  ivec2 corner = tile * side;
  vec3 ray = rayThrough(vec2(corner) + 0.5 * float(side));
  float rayLength = length(ray);
  vec3 direction = ray / rayLength;
  float width = clouds.sight.y;
  RaySpan span = layerOfCone(direction.y, width);
  if (span.end <= span.begin) return;
  // The corners of a tile reach farther than its middle by the width of the cone at most.
  float surface = sceneDistance(farthestDepth(corner, side), ray) * (1.0 + 2.0 * width);
  span = occupiedSpan(direction, width, overlap(span, make_raySpan(0.0, surface)));
  if (span.end <= span.begin) return;
  uint index = atomicAdd(tiles.groups.w, 1u);
  tiles.tasks[index] = Task(packedPlace(tile), span.begin, span.end, 0u);
  atomicMax(tiles.groups.x, min(index + 1u, kGroupsARow));
  atomicMax(tiles.groups.y, index / kGroupsARow + 1u);
}
