// Which pieces of hedges and which fruit trees a frame shows: one invocation a piece of 20 m, four on the west and four on
// the north border of a block of fields, or a tree of a block of gardens.
#include "places/placing.glsl"

const int kPiecesABorder = 4;
uniform int hedgeVillage;  // of the map

// No building's walls are so near.
bool isOffHouses(vec2 onMap, float fromM) {
  uint cell = placeCellAt(onMap).y;
  int first = int(cell & 0xffffu), end = first + 2 * int(cell >> 16 & 0xffu);
  bool isOff = true;
  for (int i = first; i < end; i += 2) {
    vec4 foot = uintBitsToFloat(placeDatum(i)), form = uintBitsToFloat(placeDatum(i + 1));
    vec2 d = onMap - foot.xy;
    vec2 past = abs(vec2(d.y * form.x - d.x * form.y, dot(d, form.xy))) - vec2(foot.w, form.z);
    isOff = isOff && max(past.x, past.y) > fromM;
  }
  return isOff;
}

void placeHedge(int block, int piece) {
  int village = hedgeVillage;
  vec4 axes = uintBitsToFloat(placeDatum(village * kVillageTexels));
  uint bits = placeDatum(village * kVillageTexels + 1).x;
  ivec2 cell = ivec2(block % kFieldBlocks, block / kFieldBlocks);
  int axis = piece / kPiecesABorder;
  float from = float(piece % kPiecesABorder) / float(kPiecesABorder), to = from + 1.0 / float(kPiecesABorder);
  uint line = placeDatum(village * kVillageTexels + 2 + cell.y / 4)[cell.y % 4];
  int kind = int(line >> (2 * cell.x) & 3u);
  uint own = placeBits(bits, uint(block * 16 + piece), 77u);
  bool isTree = kind == kGardenBlock;
  bool isThere = isTree ? byteOf(own, 0) < 0.6
                        : kind == kCropBlock && borderKind(bits, cell.x, cell.y, axis) == kHedge && byteOf(own, 0) < 0.93;
  vec2 corner = vec2(cell);
  vec2 first = axis == 0 ? corner + vec2(0.0, from) : corner + vec2(from, 0.0);
  vec2 second = axis == 0 ? corner + vec2(0.0, to) : corner + vec2(to, 0.0);
  vec2 stem = corner + vec2(byteOf(own, 1), byteOf(own, 2));
  float treeM = mix(3.0, 5.5, byteOf(own, 3));
  first = isTree ? stem - vec2(0.5 * treeM / kFieldBlockM, 0.0) : first;
  second = isTree ? stem + vec2(0.5 * treeM / kFieldBlockM, 0.0) : second;
  // Near enough at all: the middle of the block.
  vec2 rough = (corner + 0.5 - 8.0) * kFieldBlockM;
  vec2 middleOfBlock = axes.xy + axes.zw * rough.x + vec2(-axes.w, axes.z) * rough.y + placeFrame.xy - eyeFromBase.xz;
  int pieces = isThere && length(middleOfBlock) < placeReach.w + 70.0 ? 1 : 0;
  for (int p = 0; p < pieces; ++p) {
    vec2 a = placeInBlocks(first, bits), b = placeInBlocks(second, bits);
    vec2 right = vec2(-axes.w, axes.z);
    vec2 west = axes.xy + axes.zw * a.x + right * a.y, east = axes.xy + axes.zw * b.x + right * b.y;
    vec2 onMap = 0.5 * (west + east);
    NearestWay way = nearestWay(onMap, placeCellAt(onMap).x);
    float heightA = drawnHeight(west + placeFrame.xy), heightB = drawnHeight(east + placeFrame.xy);
    vec2 ground = onMap + placeFrame.xy - eyeFromBase.xz;
    vec3 foot = vec3(ground.x, 0.5 * (heightA + heightB) - eyeFromBase.y, ground.y);
    float distanceM = length(foot);
    float share = 1.0 - smoothstep(placeReach.z, placeReach.w, distanceM);
    vec2 along = east - west;
    float lengthM = length(along);
    int shown = share > 0.0 && heightA > -1e5 && heightB > -1e5 && way.away > wayHalfM(way.kind) + (isTree ? 3.5 : 5.0) &&
                        (!isTree || isOffHouses(onMap, 1.0 + 0.5 * treeM)) &&
                        isInView(foot + vec3(0.0, 1.0, 0.0), 0.6 * lengthM + 2.0) ? 1 : 0;
    for (int show = 0; show < shown; ++show) {
      PlaceInstance made;
      made.foot = vec4(foot, 0.6);
      made.form = isTree ? vec4(treeM, treeM, treeM * 1.15, heightB - heightA)
                         : vec4(mix(1.7, 2.6, byteOf(own, 1)), lengthM * 1.12, mix(1.3, 2.7, byteOf(own, 2)), heightB - heightA);
      made.turn = vec4(along / lengthM, 1.0, isTree ? 1.0 : 0.0);
      put(1u, lit(made, foot + vec3(0.0, 1.0, 0.0), own, share));
    }
  }
}
