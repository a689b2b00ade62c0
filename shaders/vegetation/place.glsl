// Which trees a frame shows: one invocation a cell of the lattice, one work group a tile of 8 x 8 cells.
#include "terrain/placing.glsl"
#include "terrain/drawn_height.glsl"
#include "shared/woods.glsl"
#include "vegetation/instance.glsl"
#include "vegetation/wind.glsl"

layout(std430, binding = 0) readonly buffer Tiles { ivec2 tiles[]; };  // north-west cells, counted from the base
layout(std430, binding = 1) writeonly buffer Instances { TreeInstance instances[]; };
layout(std430, binding = 2) buffer Commands { DrawCommand commands[kInstanceKinds]; };

const int kTileCells = 8;  // along a side

uniform vec4 treeReach;      // metres: meshes turn into impostors between x and y, impostors into paint between z and w
uniform float treeDensity;   // WoodsSettings::density
uniform vec4 clearings[8];   // strips, two rows each: middle (from the base), unit vector along; half length, half width
uniform int clearingCount;

bool isCleared(vec2 place) {
  bool cleared = false;
  for (int i = 0; i < clearingCount; ++i) {
    vec2 from = place - clearings[2 * i].xy, along = clearings[2 * i].zw;
    vec2 at = abs(vec2(dot(from, along), from.y * along.x - from.x * along.y));
    cleared = cleared || (at.x < clearings[2 * i + 1].x && at.y < clearings[2 * i + 1].y);
  }
#ifdef PLACES
  cleared = cleared || isSettledAt(place);
#endif
  return cleared;
}

// What of it is drawn as what: the mesh's share, and what is drawn at all.
vec2 sharesDrawn(float distanceM) {
  return vec2(1.0 - smoothstep(treeReach.x, treeReach.y, distanceM), 1.0 - smoothstep(treeReach.z, treeReach.w, distanceM));
}

// What of the light from above, from the sun and from below meets snow on branches that it covers.
const vec3 kSnowOnBranches = vec3(0.5, 0.35, 0.05);

// snow: share of open ground there that is covered.
TreeInstance instanceOf(Tree tree, vec3 foot, float density, float phase, float snow, vec2 drawn) {
  vec3 middle = foot + vec3(0.0, 0.5 * tree.heightM, 0.0);
  vec3 shares = sharesAt(middle);
  vec3 foliage = foliageAlbedo(tree.leafy) * (0.72 + 0.75 * tree.tint);
  vec3 hazeAlone = endingLandThroughAir(vec3(0.0), middle, leftOfLight(middle));
  vec3 passed = (endingLandThroughAir(vec3(1.0), middle, leftOfLight(middle)) - hazeAlone) / kPi;
  vec3 white = kSnowOnBranches * snow;
  float angle = 2.0 * kPi * tree.turn;
  TreeInstance made;
  made.foot = vec4(foot, tree.heightM);
  made.form = vec4(tree.radiusM, cos(angle), sin(angle), drawn.x);
  made.sun = vec4(frame.sunLight.xyz * shares.x * passed * mix(foliage, kFallenSnow, white.y), float(tree.kind) + 0.5 * snow);
  vec3 lamps = lampsAt(middle);
  made.above = vec4((frame.skyLight.xyz * shares.y + diffuseSun(shares) + lamps) * passed * mix(foliage, kFallenSnow, white.x),
                    density);
  made.below = vec4((frame.groundLight.xyz * shares.y + lamps) * passed * mix(foliage, kFallenSnow, white.z), phase);
  made.air = vec4(hazeAlone, drawn.y);
  made.bend = bentBy(tree.heightM, phase);
  return made;
}

void put(uint list, TreeInstance made) {
  uint slot = atomicAdd(commands[list].instanceCount, 1u);
  instances[commands[list].baseInstance + slot] = made;
}

// Of a tile's cells, those on the eye's side first: what trees hide of those behind them is left out by the depth test.
ivec2 cellOf(ivec2 tile, ivec2 number) {
  bvec2 isBefore = lessThan((vec2(tile) + 0.5 * float(kTileCells)) * kTreeCellM, eyeFromBase.xz);
  return tile + ivec2(isBefore.x ? kTileCells - 1 - number.x : number.x, isBefore.y ? kTileCells - 1 - number.y : number.y);
}

// Without loops for what is left out: a software renderer goes through each once anyway, and through one that runs once
// twice.
void placeTree(ivec2 cell) {
  uint bits = treeBits(uvec2(baseChunk * kTreeCellsPerChunk + cell));
  vec2 place = vec2(cell) * kTreeCellM + treeStem(bits);
  vec2 ground = place - eyeFromBase.xz;
  LandNoise noise = woodNoise(uvec2(baseChunk), place);
  float heightM = drawnHeight(place);
  vec3 foot = vec3(ground.x, heightM - eyeFromBase.y, ground.y);
  float distanceM = length(foot);
  LandTexel texel = landTexel(place, distanceM);
  float up = texel.metres > 0.0 ? normalAt(texel, vec2(0.0)).y : 0.0;
  Tree tree = treeOf(bits, growthHeight(heightM), up, noise, treeDensity);
  vec2 drawn = sharesDrawn(distanceM);
  vec3 middle = foot + vec3(0.0, 0.5 * tree.heightM, 0.0);
  if (tree.heightM <= 0.0 || drawn.y <= 0.0 || heightM <= -1e5 || !isInView(middle, 0.65 * tree.heightM + 1.0) ||
      isCleared(place))
    return;
  float density = forestDensity(growthHeight(heightM), up, 0.0, noise);
  TreeInstance made =
      instanceOf(tree, foot, density, unitOf(bits * 0x9e3779b1u), lyingSnowAt(heightM, noise), drawn);
  if (drawn.x > 0.0) put(uint(tree.kind), made);
  if (drawn.x < 1.0) put(3u, made);
}
