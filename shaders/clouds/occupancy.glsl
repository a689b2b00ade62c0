// Leaps over what is empty (include/skydrop/clouds/occupancy.h).
#include "shared/cloud_light.glsl"
#include "clouds/uniforms.glsl"

layout(binding = 3) uniform usampler3D occupancy;  // x, row, z: cells to the nearest occupied one

const ivec3 kCells = ivec3(256, 16, 256);

// A place in cells: x and z of the whole repeating field, y in rows above the base.
vec3 cellPlace(vec3 place) {
  return vec3(clouds.cells.x + place.x * clouds.cells.y, (place.y - clouds.layer.x) * clouds.cells.w,
              clouds.cells.z + place.z * clouds.cells.y);
}

float emptyCells(ivec3 cell) {
  ivec3 wrapped = ivec3(cell.x & (kCells.x - 1), clamp(cell.y, 0, kCells.y - 1), cell.z & (kCells.z - 1));
  return float(texelFetch(occupancy, wrapped, 0).x);
}

// How far a ray goes from a place, in lengths along it, before it leaves the box of `cells` around the place's own cell
// (1: that cell alone). A ray may be `wide` (in cells, at the place) and widen by `widening` cells a length; then all of
// it has to stay inside. Not positive: it is not inside.
float wayOutOfBox(vec3 at, vec3 perLength, float cells, vec3 wide, vec3 widening) {
  vec3 fromMiddle = at - (floor(at) + 0.5);
  vec3 outwards = vec3(perLength.x < 0.0 ? -1.0 : 1.0, perLength.y < 0.0 ? -1.0 : 1.0, perLength.z < 0.0 ? -1.0 : 1.0);
  vec3 room = vec3(cells - 0.5) - wide;
  vec3 ahead = (room - fromMiddle * outwards) / max(abs(perLength) + widening, vec3(1e-12));
  vec3 behind = room + fromMiddle * outwards;
  return min(behind.x, min(behind.y, behind.z)) < 0.0 ? 0.0 : min(ahead.x, min(ahead.y, ahead.z));
}

// A bent ray in cells.
struct CellRay {
  vec3 start;
  vec3 perLength;  // at its start
  float bend;      // rows
  float slack;     // rows that it leaves its tangent by over the longest leap, a diagonal of 15 cells
};

CellRay cellRay(vec3 direction) {
  vec3 start = cellPlace(vec3(0.0));
  float bend = rayBend(direction) * clouds.cells.w;
  float leap = 22.0 / clouds.cells.y;
  return CellRay(start, cellPlace(direction) - start, bend, bend * leap * leap);
}

vec3 cellOnRay(CellRay ray, float at) { return ray.start + placeOnBentRay(ray.perLength, ray.bend, at); }

// How far it goes at a place before it leaves the box of `cells` around its cell, as wayOutOfBox().
float leapOnRay(CellRay ray, float at, vec3 cell, float cells, vec3 wide, vec3 widening) {
  vec3 tangent = ray.perLength + vec3(0.0, 2.0 * ray.bend * at, 0.0);
  return wayOutOfBox(cell, tangent, cells, wide + vec3(0.0, ray.slack, 0.0), widening);
}

#ifdef LAYERS
#include "clouds/union_occupancy.glsl"
#endif
