// Which tiles have to be marched, and between which distances. A tile's rays are judged together: as one wide ray.
#include "clouds/field.glsl"
#include "clouds/occupancy.glsl"
#include "clouds/view.glsl"
#include "clouds/tiles.glsl"

layout(std430, binding = 0) buffer Tiles {
  uvec4 groups;        // of a dispatch with a group for each tile; w: tiles in the list
  uvec4 groupsOfFour;  // of a dispatch with a group for four
  Task tasks[];
} tiles;
layout(std430, binding = 1) buffer Spans { vec2 spans[]; };

#ifdef LAYERS
#include "clouds/union_spans.glsl"
#else
// Where any ray of a cone may lie in the layer; `width` is the cone's half-width at 1 m.
RaySpan layerOfCone(vec3 direction, float width) {
  float level = length(direction.xz);
  float lowest = rayBend(vec3(max(level - width, 0.0), 0.0, 0.0));
  float highest = rayBend(vec3(level + width, 0.0, 0.0));
  RaySpan underTop = bentRayUnder(-clouds.layer.x - clouds.layer.y, direction.y - width, lowest);
  RaySpan underBase = bentRayUnder(-clouds.layer.x, direction.y + width, highest);
  return bentRayInLayer(underTop, underBase, clouds.layer.z);
}

// The parts of a cone's interval in which it touches occupied cells, conservative: noted at a place in the buffer. Gives
// the whole of them.
RaySpan occupiedSpan(vec3 direction, float width, RaySpan span, int notedAt) {
  CellRay ray = cellRay(direction);
  vec3 cellsAMetre = clouds.cells.ywy;
  float pace = 0.5 / max(cellsAMetre.x, cellsAMetre.y);
  RaySpan found = make_raySpan(span.end, span.begin);
  RaySpan part = make_raySpan(span.end, span.begin);
  int parts = 0;
  float at = span.begin;
  while (at < span.end) {
    vec3 place = cellOnRay(ray, at);
    float cells = emptyCells(ivec3(floor(place)));
    float way = leapOnRay(ray, at, place, cells, cellsAMetre * (width * at), cellsAMetre * width);
    float step = max(pace, width * at);
    bool leaps = cells >= 1.0 && way > 0.1 * step;
    // A loop of one turn at most, and not a branch: a software renderer leaves it out where no tile needs it.
    bool ends = !leaps && part.end > part.begin && at - part.end > step && parts < kMostSpans - 1;
    while (ends) {
      ++parts;
      spans[notedAt + parts] = vec2(part.begin, part.end);
      part = make_raySpan(at, at);
      ends = false;
    }
    part.begin = leaps ? part.begin : min(part.begin, at);
    found.begin = leaps ? found.begin : min(found.begin, at);
    at += leaps ? way : step;
    part.end = leaps ? part.end : at;
    found.end = leaps ? found.end : at;
  }
  spans[notedAt + parts + 1] = vec2(part.begin, min(part.end, span.end));
  spans[notedAt] = vec2(float(part.end > part.begin ? parts + 1 : parts), 0.0);
  return make_raySpan(found.begin, min(found.end, span.end));
}
#endif

// The interval of a tile in which there may be cloud before a surface, its parts noted at a place in the buffer; empty: none.
RaySpan cloudSpanOf(ivec2 tile, int notedAt) {
  ivec2 corner = tile * TILE_SIDE;
  vec3 ray = rayThrough(vec2(corner) + 0.5 * float(TILE_SIDE));
  vec3 direction = normalize(ray);
  float width = clouds.sight.x;
  RaySpan span = layerOfCone(direction, width);
  if (span.end <= span.begin) return span;
  // The corners of a tile reach farther than its middle by the width of the cone at most.
  float surface = sceneDistance(farthestDepth(corner, TILE_SIDE), ray) * (1.0 + 2.0 * width);
  span = overlap(span, make_raySpan(0.0, surface));
  return occupiedSpan(direction, width, span, notedAt);
}

void listTile(ivec2 tile, RaySpan span) {
  uint index = atomicAdd(tiles.groups.w, 1u);
  tiles.tasks[index] = Task(packedPlace(tile), span.begin, span.end, 0u);
  atomicMax(tiles.groups.x, min(index + 1u, kGroupsARow));
  atomicMax(tiles.groups.y, index / kGroupsARow + 1u);
  uint four = index / 4u;
  atomicMax(tiles.groupsOfFour.x, min(four + 1u, kGroupsARow));
  atomicMax(tiles.groupsOfFour.y, four / kGroupsARow + 1u);
}

void classifyTile(ivec2 tile, ivec2 tileCount) {
  if (tile.x >= tileCount.x || tile.y >= tileCount.y) return;
  int notedAt = (tile.y * tileCount.x + tile.x) * kPlacesOfSpans;
  RaySpan span = cloudSpanOf(tile, notedAt);
  if (span.end > span.begin)
    listTile(tile, span);
  else
    spans[notedAt] = vec2(0.0);
}
