// Fields, ways and houses around the eye (render::PlaceMap): included with PLACES alone, after terrain/noise.glsl.
#include "shared/places.glsl"

layout(binding = 7) uniform usampler2D placeGrid;  // x: village + 1, pieces of ways, the first; y: buildings, the first
layout(binding = 8) uniform usampler2D placeData;
uniform vec4 placeFrame;  // xy: the map's north-west corner, metres from the base; it fades between z and w, m

const int kPlaceGridSide = 300;      // as in src/render/places/place_map_data.h
const float kPlaceGridM = 32.0;
const int kPlaceRow = 256;           // texels
const int kVillageTexels = 6;

uvec4 placeDatum(int index) { return texelFetch(placeData, ivec2(index % kPlaceRow, index / kPlaceRow), 0); }

uvec2 placeCellAt(vec2 onMap) {
  ivec2 cell = ivec2(floor(onMap / kPlaceGridM));
  bool isOn = all(greaterThanEqual(cell, ivec2(0))) && all(lessThan(cell, ivec2(kPlaceGridSide)));
  return isOn ? texelFetch(placeGrid, cell, 0).xy : uvec2(0u);
}

// A place in the blocks of a village, and which kind the block there is.
struct InBlocks {
  vec2 blocks;
  uint village;
  int kind;
};
InBlocks inBlocks(vec2 onMap, int village) {
  vec4 axes = uintBitsToFloat(placeDatum(village * kVillageTexels));
  uint bits = placeDatum(village * kVillageTexels + 1).x;
  vec2 d = onMap - axes.xy;
  vec2 blocks = blocksOf(vec2(dot(d, axes.zw), d.y * axes.z - d.x * axes.w), bits);
  ivec2 whole = ivec2(floor(blocks));
  bool isIn = all(greaterThanEqual(whole, ivec2(0))) && all(lessThan(whole, ivec2(kFieldBlocks)));
  int row = clamp(whole.y, 0, kFieldBlocks - 1);
  uint line = placeDatum(village * kVillageTexels + 2 + row / 4)[row % 4];
  return InBlocks(blocks, bits, isIn ? int(line >> (2 * clamp(whole.x, 0, kFieldBlocks - 1)) & 3u) : kNoBlock);
}

// The way that is nearest by its edge: distance from its middle (m), kind.
struct NearestWay {
  float away;
  int kind;
};
NearestWay nearestWay(vec2 onMap, uint cell) {
  NearestWay nearest = NearestWay(1e4, kStreet);
  int first = int(cell & 0xffffu), end = first + int(cell >> 16 & 0xffu);
  float least = 1e4;
  for (int i = first; i < end; ++i) {
    uvec4 piece = placeDatum(i);
    vec4 ends = uintBitsToFloat(piece);
    int kind = int(piece.x & 3u);
    float away = awayFromWay(onMap, ends.xy, ends.zw);
    bool isNearer = away - wayHalfM(kind) < least;
    least = isNearer ? away - wayHalfM(kind) : least;
    nearest.away = isNearer ? away : nearest.away;
    nearest.kind = isNearer ? kind : nearest.kind;
  }
  return nearest;
}

// Loops that run once or not at all stand for branches: a software renderer runs both sides of a branch.
PlaceLook placeLookAt(vec2 place, LandSurface land, float distanceM, float footprint, LandNoise noise) {
  vec2 onMap = place - placeFrame.xy;
  float shown = 1.0 - smoothstep(placeFrame.z, placeFrame.w, distanceM);
  uint cell = shown > 0.0 ? placeCellAt(onMap).x : 0u;
  PlaceLook look = noPlace();
  int villages = cell >> 24 != 0u ? 1 : 0;
  for (int v = 0; v < villages; ++v) {
    InBlocks at = inBlocks(onMap, int(cell >> 24) - 1);
    int crops = at.kind == kCropBlock ? 1 : 0, gardens = at.kind == kGardenBlock ? 1 : 0;
    for (int f = 0; f < crops; ++f) {
      FieldPlot plot = fieldPlotAt(at.blocks, at.village, false);
      look = fieldLook(cropLook(plot, footprint, noise), plot, false, footprint, noise);
    }
    for (int f = 0; f < gardens; ++f) {
      FieldPlot plot = fieldPlotAt(at.blocks, at.village, true);
      look = fieldLook(gardenLook(plot, footprint, noise), plot, true, footprint, noise);
    }
  }
  NearestWay way = nearestWay(onMap, cell);
  int ways = way.away < wayHalfM(way.kind) + 5.0 + footprint ? 1 : 0;
  for (int w = 0; w < ways; ++w) look = withWay(look, land, way.away, way.kind, footprint, noise);
  look.share *= shown;
  look.paved *= shown;
  return look;
}

// No tree stands there.
bool isSettledAt(vec2 place) {
  vec2 onMap = place - placeFrame.xy;
  uint cell = placeCellAt(onMap).x;
  bool settled = false;
  int villages = cell >> 24 != 0u ? 1 : 0;
  for (int v = 0; v < villages; ++v) settled = inBlocks(onMap, int(cell >> 24) - 1).kind != kNoBlock;
  NearestWay way = nearestWay(onMap, cell);
  return settled || way.away < wayHalfM(way.kind) + kTreesFromWayM;
}

// What houses leave of the sun's light (x) and of the sky's (y) on the ground at a place: the sun's ray against walls and
// roofs, soft by a tenth of a metre or a pixel; and less sky at the foot of walls.
vec2 lightPastHouses(vec2 place, float heightM, float distanceM, float footprint) {
#ifdef RICH_LAND
  const float kShadowsM = 500.0;
#else
  const float kShadowsM = 160.0;
#endif
  vec2 onMap = place - placeFrame.xy;
  float shown = 1.0 - smoothstep(0.7 * kShadowsM, kShadowsM, distanceM);
  uint cell = shown > 0.0 ? placeCellAt(onMap).y : 0u;
  int first = int(cell & 0xffffu), end = first + 2 * int(cell >> 16 & 0xffu);
  vec3 sun = vec3(frame.toSun.xz, max(frame.toSun.y, 0.06)).xzy;
  float soft = max(footprint, 0.15);
  float hidden = 0.0, closed = 0.0;
  for (int i = first; i < end; i += 2) {
    vec4 foot = uintBitsToFloat(placeDatum(i));       // middle, foot's height, half width
    vec4 form = uintBitsToFloat(placeDatum(i + 1));   // along, half length, up to the middle of the roof
    vec2 d = onMap - foot.xy;
    vec2 at = vec2(d.y * form.x - d.x * form.y, dot(d, form.xy));
    float y = heightM - foot.z;
    vec2 ray = vec2(sun.z * form.x - sun.x * form.y, dot(sun.xz, form.xy));
    ray += vec2(equal(ray, vec2(0.0))) * 1e-6;
    vec2 halves = vec2(foot.w, form.z);
    vec2 one = (-halves - at) / ray, two = (halves - at) / ray;
    vec2 enter = min(one, two), leave = max(one, two);
    float from = max(max(enter.x, enter.y), 0.0);
    float top = (form.w - y) / sun.y;
    float passes = min(min(leave.x, leave.y), top) - from;
    hidden = max(hidden, saturate(passes / soft));
    vec2 past = max(abs(at) - halves, vec2(0.0));
    closed = max(closed, saturate(1.0 - length(past) / 2.2));
  }
  return vec2(1.0 - hidden * shown, 1.0 - 0.55 * closed * closed * shown);
}
