// Leaps over what is empty in all layers. The occupancies are one upon the other in one texture (clouds/occupancy.glsl).
// Part of clouds/occupancy.glsl, of variants with LAYERS.

vec3 cellPlaceIn(const int i, vec3 place) {
  vec4 cells = clouds.layers[i].cells;
  return vec3(cells.x + place.x * cells.y, (place.y - clouds.layers[i].shell.x) * cells.w, cells.z + place.z * cells.y);
}

CellRay cellRayIn(const int i, vec3 direction) {
  vec3 start = cellPlaceIn(i, vec3(0.0));
  float bend = rayBend(direction) * clouds.layers[i].cells.w;
  float leap = 22.0 / clouds.layers[i].cells.y;
  return CellRay(start, cellPlaceIn(i, direction) - start, bend, bend * leap * leap);
}

float emptyCellsIn(const int i, ivec3 cell) {
  ivec3 wrapped = ivec3(cell.x & (kCells.x - 1), clamp(cell.y, 0, kCells.y - 1) + i * kCells.y, cell.z & (kCells.z - 1));
  return float(texelFetch(occupancy, wrapped, 0).x);
}
