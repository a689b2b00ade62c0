// Where a tile's cone may meet cloud of any layer: one walk through all occupancies, which leaps as far as is empty in
// each. For shaders/clouds/classify.glsl, which declares the list of spans.

// Where any ray of a cone may lie in the shell of a layer; `width` is the cone's half-width at 1 m.
RaySpan shellOfCone(const int i, vec3 direction, float width) {
  float level = length(direction.xz);
  float lowest = rayBend(vec3(max(level - width, 0.0), 0.0, 0.0));
  float highest = rayBend(vec3(level + width, 0.0, 0.0));
  vec4 shell = clouds.layers[i].shell;
  RaySpan underTop = bentRayUnder(-shell.x - shell.y, direction.y - width, lowest);
  RaySpan underBase = bentRayUnder(-shell.x, direction.y + width, highest);
  return bentRayInLayer(underTop, underBase, clouds.layer.z);
}

// From the nearest of them to the farthest.
RaySpan layerOfCone(vec3 direction, float width) {
  RaySpan all = make_raySpan(clouds.layer.z, 0.0);
#define HULL(i)                                                                \
  {                                                                            \
    RaySpan span = shellOfCone(i, direction, width);                           \
    bool isThere = span.end > span.begin;                                      \
    all.begin = isThere ? min(all.begin, span.begin) : all.begin;              \
    all.end = isThere ? max(all.end, span.end) : all.end;                      \
  }
  EACH_LAYER(HULL)
#undef HULL
  return all;
}

// What one layer leaves of a leap from a place on: 0 where it may hold cloud.
float leapOfCone(const int i, CellRay ray, RaySpan shell, float at, float width, float step) {
  float way = at < shell.begin ? shell.begin - at : 1e9;
  for (bool isIn = at >= shell.begin && at < shell.end; isIn; isIn = false) {
    vec3 cellsAMetre = clouds.layers[i].cells.ywy;
    vec3 place = cellOnRay(ray, at);
    float cells = emptyCellsIn(i, ivec3(floor(place)));
    way = leapOnRay(ray, at, place, cells, cellsAMetre * (width * at), cellsAMetre * width);
    way = cells >= 1.0 && way > 0.1 * step ? way : 0.0;
  }
  return way;
}

// The parts of a cone's interval in which it touches occupied cells, conservative: noted at a place in the buffer. Gives
// the whole of them.
RaySpan occupiedSpan(vec3 direction, float width, RaySpan span, int notedAt) {
  CellRay rays[LAYERS];
  RaySpan shells[LAYERS];
  float finest = 0.0;
#define RAY(i)                                                                         \
  rays[i] = cellRayIn(i, direction);                                                   \
  shells[i] = shellOfCone(i, direction, width);                                        \
  finest = max(finest, max(clouds.layers[i].cells.y, clouds.layers[i].cells.w));
  EACH_LAYER(RAY)
#undef RAY
  float pace = 0.5 / finest;
  RaySpan found = make_raySpan(span.end, span.begin);
  RaySpan part = make_raySpan(span.end, span.begin);
  int parts = 0;
  float at = span.begin;
  while (at < span.end) {
    float step = max(pace, width * at);
    float way = 1e9;
#define LEAP(i) way = min(way, leapOfCone(i, rays[i], shells[i], at, width, step));
    EACH_LAYER(LEAP)
#undef LEAP
    bool leaps = way > 0.0;
    bool ends = !leaps && part.end > part.begin && at - part.end > step && parts < kMostSpans - 1;
    // A loop of one turn at most, and not a branch: a software renderer leaves it out where no tile needs it.
    for (; ends; ends = false) {
      ++parts;
      spans[notedAt + parts] = vec2(part.begin, part.end);
      part = make_raySpan(at, at);
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
