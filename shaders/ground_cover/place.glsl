// What stands on the ground in a frame: one invocation a cell of a lattice, one work group a tile of 8 x 8 cells.
#include "terrain/placing.glsl"
#include "terrain/drawn_height.glsl"
#include "shared/ground_cover.glsl"
#include "ground_cover/instance.glsl"
#include "ground_cover/wind.glsl"

layout(std430, binding = 0) readonly buffer Tiles { ivec4 tiles[]; };  // north-west cell, counted from the base; lattice
layout(std430, binding = 1) writeonly buffer Instances { CoverInstance instances[]; };
layout(std430, binding = 2) buffer Commands { DrawCommand commands[kCoverLists]; };
layout(std430, binding = 3) writeonly buffer Lists { uint numbers[]; };  // of instances

uniform vec4 coverReaches;   // of the lattices, m
uniform float coverFineM;    // tufts are drawn with fine blades up to this distance
uniform vec4 mownFrame;      // the nearest strip: its middle (from the base), unit vector along
uniform vec2 mownHalf;       // half its length and width; negative: there is none near by

bool isBare(vec2 place) {
  vec2 from = place - mownFrame.xy, along = mownFrame.zw;
  vec2 at = abs(vec2(dot(from, along), from.y * along.x - from.x * along.y));
  bool bare = at.x < mownHalf.x && at.y < mownHalf.y;
#ifdef PLACES
  bare = bare || isSettledAt(place);
#endif
  return bare;
}

CoverSite siteAt(vec2 place, float heightM, vec3 normal, LandNoise noise) {
  CoverSite site;
  site.patches = chunkNoise(uvec2(baseChunk), place, 120);
  noise.clod = 0.6 * site.patches.y;
  float grows = growthHeight(heightM);
  site.land = landSurface(grows, normal.y, 0.0, noise, 0.0, Crowns(vec2(0.0), 0.0, 0.0), 0.0);
  site.heightM = heightM;
  site.normalUp = normal.y;
  site.wooded = forestDensity(grows, normal.y, 0.0, noise);
  site.region = noise.region;
  site.tuft = noise.tuft;
  return site;
}

CoverInstance instanceOf(Cover cover, CoverSite site, vec2 place, vec3 foot, vec3 normal, float grown, uint bits) {
  float distanceM = length(foot);
  vec3 shares = sharesAt(foot);
  vec3 hazeAlone = endingLandThroughAir(vec3(0.0), foot, leftOfLight(foot));
  vec3 passed = (endingLandThroughAir(vec3(1.0), foot, leftOfLight(foot)) - hazeAlone) / kPi;
  CoverInstance made;
  made.foot = vec4(foot, cover.heightM * grown);
  made.form = vec4(cover.radiusM * grown, 2.0 * kPi * cover.turn, float(cover.kind), float(bits & 0xffffffu));
  made.normal = vec4(normal, 1.0 - smoothstep(0.55 * coverFineM, coverFineM, distanceM));
  made.sun = vec4(frame.sunLight.xyz * shares.x * passed, cover.dry);
  made.above = vec4((frame.skyLight.xyz * shares.y + diffuseSun(shares) + lampsAt(foot)) * passed, cover.tint);
  // From below comes what the ground around it throws back.
  vec3 onGround = made.sun.xyz * max(dot(normal, frame.toSun.xyz), 0.0) + made.above.xyz;
  made.below = vec4(site.land.albedo * onGround, grown);
  made.air = vec4(hazeAlone, distanceM);
  made.albedo = vec4(site.land.albedo, fract(1.7 * site.patches.y + 2.3 * site.tuft + 0.23 * cover.tint));
  made.bend = coverBend(place, made.foot.w, cover.tint);
  return made;
}

// Stones and boulders by how many pixels their radius takes: a software renderer pays for each triangle, and most for those
// of less than a few pixels.
const float kFarStone = 8.0;
const float kFineBoulder = 16.0;

int listOf(int kind, float distanceM, float radiusM) {
  float pixels = radiusM / max(distanceM * frame.depthToSea.w, 1e-6);
  int stone = pixels < kFarStone ? 4 : (kind == kBoulder && pixels > kFineBoulder ? 6 : 5);
  return kind == kTuft ? (distanceM < coverFineM ? 0 : 1) : (kind == kStone || kind == kBoulder ? stone : kind + 1);
}

const uint kTileCells = 8u;    // along a side
const float kSnowedIn = 0.8;  // of a plant's height, where snow covers the ground

void placeCover(uint tileNumber, uint cellNumber) {
  ivec4 tile = tiles[tileNumber];
  int level = tile.z;
  float cellM = coverCellM(level), reachM = coverReaches[level];
  ivec2 cell = tile.xy + ivec2(cellNumber % kTileCells, cellNumber / kTileCells);
  uint bits = coverBits(uvec2(baseChunk * (kCoverCellsPerChunk >> level) + cell), level);
  vec2 place = (vec2(cell) + coverStem(bits)) * cellM;
  float heightM = drawnHeight(place);
  vec3 foot = vec3(place.x - eyeFromBase.x, heightM - eyeFromBase.y, place.y - eyeFromBase.z);
  float distanceM = length(foot);
  LandTexel texel = landTexel(place, distanceM);
  vec3 normal = texel.metres > 0.0 ? normalAt(texel, vec2(0.0)) : vec3(0.0, 1.0, 0.0);
  LandNoise noise = woodNoise(uvec2(baseChunk), place);
  CoverSite site = siteAt(place, heightM, normal, noise);
  Cover cover = coverOf(bits, level, site);
  // Snow lies over plants but for their tips, and between stones.
  float snow = lyingSnowAt(heightM, noise);
  bool isStone = cover.kind == kStone || cover.kind == kBoulder;
  float grown = coverGrown(distanceM, reachM, unitOf(bits * 0x9e3779b1u)) * (isStone ? 1.0 : 1.0 - kSnowedIn * snow);
  site.land.albedo = mix(site.land.albedo, kFallenSnow, snow);
  if (cover.kind == kNoCover || grown <= 0.0 || texel.metres <= 0.0 || heightM <= -1e5 ||
      !isInView(foot + vec3(0.0, 0.5 * cover.heightM, 0.0), cover.heightM + cover.radiusM) || isBare(place))
    return;
  uint number = tileNumber * kTileCells * kTileCells + cellNumber;
  instances[number] = instanceOf(cover, site, place, foot, normal, grown, bits);
  int list = listOf(cover.kind, distanceM, cover.radiusM * grown);
  uint slot = atomicAdd(commands[list].instanceCount, 1u);
  numbers[commands[list].baseInstance + slot] = number;
}
