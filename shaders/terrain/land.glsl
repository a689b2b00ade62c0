// Normals and colours of the land at any place.
#include "terrain/noise.glsl"
#include "terrain/light_shares.glsl"
#include "shared/land_material.glsl"
#include "shared/ground_picture.glsl"  // before what is conditional: a file is included once
#include "shared/terrain_grid.glsl"
#include "terrain/spot.glsl"
#include "terrain/fallen.glsl"
#include "flash_light.glsl"

layout(binding = 1) uniform sampler2DArray chunkNormals;
layout(binding = 2) uniform usampler2D chunkTable;  // layers by level and place: 32 x 32 cells a level; 0xffff: none

uniform float chunkSplit[kMaxChunkLevel + 1];  // from this distance on the samples of a level are fine enough

const uint kNoChunk = 0xffffu;

// By which plants, rock and snow go. ALPINE_BELTS: the land is that of elevation data.
float growthHeight(float heightM) {
#ifdef ALPINE_BELTS
  return alpineBeltHeight(heightM);
#else
  return heightM;
#endif
}

// The coarsest level of chunks whose samples are fine enough at a distance.
int levelAt(float distanceM) {
  int level = 0;
  for (int l = 1; l <= kMaxChunkLevel; ++l) level += distanceM >= chunkSplit[l] ? 1 : 0;
  return level;
}

vec3 unpackedNormal(vec2 unorm) {
  vec2 e = (unorm * 255.0 - 128.0) / 127.0;
  vec2 xz = vec2(e.x + e.y, e.x - e.y) * 0.5;
  return normalize(vec3(xz.x, 1.0 - abs(xz.x) - abs(xz.y), xz.y));
}

// Where the normals of a place are: texture coordinates and layer; and how many metres a texel covers. metres 0: none
// is at hand.
struct LandTexel {
  vec3 at;
  float metres;
};

// At a position (metres) inside a chunk of level 0, from the finest chunk at hand that is not finer than `level`.
LandTexel texelInChunk(ivec2 chunk, vec2 inside, int level) {
  uint layer = kNoChunk;
  for (; level <= kMaxChunkLevel; ++level) {
    ivec2 entry = (chunk >> level) & (kChunkTableSide - 1);
    layer = texelFetch(chunkTable, ivec2(entry.x, entry.y + level * kChunkTableSide), 0).r;
    if (layer != kNoChunk) break;
  }
  if (layer == kNoChunk) return LandTexel(vec3(0.0), 0.0);
  vec2 sampleAt = (vec2(chunk & ((1 << level) - 1)) * float(kChunkCells) + inside * 0.25) / float(1 << level);
  vec2 at = (sampleAt + (float(kNormalMargin) + 0.5)) / float(kNormalSide);
  return LandTexel(vec3(at, float(layer)), float(4 << level));
}

// At a place, metres from the base.
LandTexel landTexel(vec2 place, float distanceM) {
  vec2 cell = floor(place / kChunkMetres);
  return texelInChunk(baseChunk + ivec2(cell), place - cell * kChunkMetres, levelAt(distanceM));
}

// `aside` in texture coordinates.
vec3 normalAt(LandTexel texel, vec2 aside) {
  return unpackedNormal(texture(chunkNormals, vec3(texel.at.xy + aside, texel.at.z)).rg);
}

// The land over 24 m (or two texels, where those are wider): two neighbours on each axis, which every chunk has also for the
// places on its border.
struct LandForm {
  float curvature;  // how much the normals diverge: ridges positive, hollows negative
  vec3 normal;      // the mean of theirs
};

LandForm landForm(LandTexel texel) {
  if (texel.metres <= 0.0) return LandForm(0.0, vec3(0.0, 1.0, 0.0));
  float aside = max(kNormalReachM / texel.metres, 1.0) / float(kNormalSide);
  vec2 step = vec2(aside, 0.0);
  vec3 east = normalAt(texel, step), west = normalAt(texel, -step);
  vec3 south = normalAt(texel, step.yx), north = normalAt(texel, -step.yx);
  return LandForm(0.5 * (east.x - west.x + south.z - north.z), 0.25 * (east + west + south + north));
}

const float kTreeMetres = 8.0;  // between trees

// A place of the land, seen from where the frame is.
struct LandSight {
  vec2 place;       // metres from the base
  float heightM;    // above the sea
  float footprint;  // what a pixel covers, metres
  float treeShare;  // how much of single trees is shown
  float facing;     // cosine at which the land is seen
  vec3 normal;      // of the samples
  LandTexel texel;
};

LandSight landSight(vec3 relative) {
  float distanceM = length(relative);
  LandSight sight;
  sight.place = eyeFromBase.xz + relative.xz;
  sight.heightM = eyeFromBase.y + relative.y;
  sight.texel = landTexel(sight.place, distanceM);
  sight.normal = sight.texel.metres > 0.0 ? normalAt(sight.texel, vec2(0.0)) : vec3(0.0, 1.0, 0.0);
  // Wider where the land is seen at a slant.
  sight.facing = -dot(sight.normal, relative) / distanceM;
  sight.footprint = distanceM * frame.depthToSea.w / sqrt(clamp(sight.facing, 0.25, 1.0));
  // Crowns are painted on the ground: close by and along it that shows, and woods are drawn as scrub.
  sight.treeShare = resolved(kTreeMetres, sight.footprint) * smoothstep(60.0, 200.0, distanceM) *
                    smoothstep(0.08, 0.30, sight.facing);
  return sight;
}

#ifdef GROUND_PICTURE
#include "terrain/ground_picture.glsl"
#endif
#ifdef GRASS_STRIP
#include "terrain/grass_strip.glsl"
#endif
#ifdef PLACES
#include "terrain/places.glsl"
#endif
#ifdef STANDING_WOODS
#include "terrain/wood_floor.glsl"

// Of woods that stand the land shows the floor; lightShares: of the sun's light what trees leave.
// treed: the share of the ground where they may stand.
LandSurface belowTrees(LandSurface land, LandSight sight, LandNoise noise, float distanceM, float treed, inout vec3 lightShares) {
  float stand = standingShare(distanceM);
  float density = forestDensity(growthHeight(sight.heightM), sight.normal.y, 0.0, noise) * stand * treed;
  float leafy = saturate(0.45 + 0.7 * noise.region - beltHeight(growthHeight(sight.heightM), noise) * 0.0009);
  land.albedo = floorAlbedo(land.albedo, land.wooded * stand, leafy, noise);
  land.litter += (1.0 - land.litter - land.scree - land.rock - land.sand - land.snow) * land.wooded * stand;
  land.wooded *= 1.0 - stand;
  lightShares.x *= sunPastTrees(sight.place, distanceM, density);
  lightShares.y *= 1.0 - 0.35 * density * standingReach.w;
  return land;
}
#endif

#ifdef GROUND_DETAIL
#include "terrain/ground_detail.glsl"
#ifdef RICH_LAND
#include "terrain/erosion_lines.glsl"
#endif
#ifdef PLACES
// Less of it where the ground is paved or trodden.
Detail onPavement(Detail detail, float paved) {
  return Detail(detail.slope * (1.0 - 0.9 * paved), detail.tint * (1.0 - 0.75 * paved), detail.height * (1.0 - 0.9 * paved));
}
#endif
#endif

// All but the finest.
LandNoise coarseNoise(LandSight sight) {
  vec2 wide = noiseAt(sight.place, 1), middle = turnedNoiseAt(sight.place, 1), fine = noiseAt(sight.place, 24);
  float middleShare = resolved(192.0, sight.footprint), fineShare = resolved(40.0, sight.footprint);
  LandNoise noise;
  noise.region = wide.x * 0.7 + middle.y * 0.3 * middleShare;
  noise.grove = (middle.x * 0.65 + fine.y * 0.35 * fineShare) * middleShare;
  noise.tuft = fine.x * fineShare;
  noise.clod = 0.0;
  noise.grain = 0.0;
  return noise;
}

vec3 litLand(LandSurface land, vec3 normal, vec3 relative, vec3 lightShares) {
  vec3 light = irradianceOf(normal, land.open, lightShares);
#ifdef SPOT_LIGHT
  light += spotOn(relative, normal);
#endif
#ifdef FLASH_LIGHT
  light += flashOn(relative, normal);
#endif
  return land.albedo / kPi * light;
}

// Light from the land (or the sea's floor) at a place `relative` to the eye, without what lies between;
// `lightShares` reach it.
#ifdef RICH_LAND
const float kClodMetres = 8.0;
const float kGrainMetres = 1.333;

vec3 landLight(vec3 relative, vec3 lightShares) {
  LandSight sight = landSight(relative);
  LandNoise noise = coarseNoise(sight);
  vec4 clod = spaceNoiseAt(sight.place, sight.heightM, 120) * resolved(kClodMetres, sight.footprint);
  vec4 grain = spaceNoiseAt(sight.place, sight.heightM, 720) * resolved(kGrainMetres, sight.footprint);
  noise.clod = clod.w;
  noise.grain = grain.w;

  uvec2 cell;
  vec2 inside;
  latticeOf(sight.place, int(kChunkMetres / kTreeMetres), cell, inside);
  Crowns crowns = crownsAt(cell, inside);
  LandForm form = landForm(sight.texel);
#ifdef GROUND_DETAIL
  RockLayers layers = rockLayers(sight.heightM, faultsAt(sight, noise.grove), noise, sight.footprint);
  Erosion erosion = erosionAt(sight, form.normal, noise);
  vec2 strata = vec2(erodedStrata(layers.tone, erosion), 0.0);
#else
  vec2 strata = rockStrata(sight.heightM, 22.0 * noise.grove + 9.0 * noise.tuft, sight.footprint);
#endif
  vec3 normal = sight.normal;
#ifdef STANDING_WOODS
  sight.treeShare *= 1.0 - standingShare(length(relative));
#endif
  LandSurface land =
      landSurface(growthHeight(sight.heightM), normal.y, form.curvature, noise, strata.x, crowns, sight.treeShare);
#ifdef PLACES
  PlaceLook places = placeLookAt(sight.place, land, length(relative), sight.footprint, noise);
  lightShares.xy *= lightPastHouses(sight.place, sight.heightM, length(relative), sight.footprint);
  land = settledLand(land, places);
  float treed = 1.0 - places.share;
#else
  const float treed = 1.0;
#endif
#ifdef STANDING_WOODS
  land = belowTrees(land, sight, noise, length(relative), treed, lightShares);
#endif
#ifdef GROUND_PICTURE
  land = worn(land, sight, length(relative));
#endif
#ifdef GRASS_STRIP
  land = mown(land, sight, noise);
#endif
#ifdef FALLEN_WATER
  Fallen lying = fallenOn(land, sight.heightM, normal, noise, -relative / length(relative));
  land = lying.land;
#endif

  // Detail as slope: of clods and grains, of ledges where the rock is bare, of the trees' crowns.
  vec3 slope = (clod.xyz * (0.10 * kClodMetres) + grain.xyz * (0.18 * kGrainMetres)) * land.roughness +
               vec3(0.0, strata.y * 3.0 * smoothstep(0.85, 0.6, normal.y), 0.0);
#ifdef GROUND_DETAIL
  slope.y += layers.ledge * land.rock;
  float wild = 1.0 - land.sand;
#ifdef PLACES
  wild *= 1.0 - places.share;
#endif
  slope.xz += erosion.slope * wild;
  land = withRills(land, erosion.cut * wild);
  land.scree += land.rock * layers.rubble;
  land.rock *= 1.0 - layers.rubble;
  Detail detail = groundDetailAt(sight, land, length(relative));
#ifdef PLACES
  detail = onPavement(detail, places.paved);
#endif
  land = withDetail(land, detail);
#endif
  slope = mix(slope, vec3(crowns.slope.x, 0.0, crowns.slope.y) * (0.55 * sight.treeShare), land.wooded);
#ifdef GROUND_DETAIL
  slope += detail.slope;
#endif
  vec3 bumped = normalize(normal - (slope - normal * dot(slope, normal)));
  vec3 light = litLand(land, bumped, relative, lightShares);
#ifdef FALLEN_WATER
  light += mirroredSky(lying, lightShares);
#endif
  return light;
}
#else
vec3 landLight(vec3 relative, vec3 lightShares) {
  LandSight sight = landSight(relative);
  Crowns noCrowns = Crowns(vec2(0.0), 0.0, 0.0);
  LandNoise noise = coarseNoise(sight);
  LandSurface land = landSurface(growthHeight(sight.heightM), sight.normal.y, 0.0, noise, 0.0, noCrowns, 0.0);
#ifdef PLACES
  PlaceLook places = placeLookAt(sight.place, land, length(relative), sight.footprint, noise);
  lightShares.xy *= lightPastHouses(sight.place, sight.heightM, length(relative), sight.footprint);
  land = settledLand(land, places);
  float treed = 1.0 - places.share;
#else
  const float treed = 1.0;
#endif
#ifdef STANDING_WOODS
  land = belowTrees(land, sight, noise, length(relative), treed, lightShares);
#endif
#ifdef GROUND_PICTURE
  land = worn(land, sight, length(relative));
#endif
#ifdef GRASS_STRIP
  land = mown(land, sight, noise);
#endif
  vec3 normal = sight.normal;
#ifdef GROUND_DETAIL
  PlainDetail detail = groundDetailAt(sight, land, length(relative));
  detail.wide.tint *= 0.7;  // humps are gentler than tufts
#ifdef PLACES
  detail.fine = onPavement(detail.fine, places.paved);
  detail.wide = onPavement(detail.wide, places.paved);
#endif
  land = withDetail(withDetail(land, detail.fine), detail.wide);
  vec3 slope = detail.fine.slope + 0.35 * detail.wide.slope;
  normal = normalize(normal - (slope - normal * dot(slope, normal)));
#endif
#ifdef FALLEN_WATER
  Fallen lying = fallenOn(land, sight.heightM, sight.normal, noise, -relative / length(relative));
  return litLand(lying.land, normal, relative, lightShares) + mirroredSky(lying, lightShares);
#else
  return litLand(land, normal, relative, lightShares);
#endif
}
#endif

vec3 landAsSeen(vec3 relative, ivec2 pixel) {
  vec3 light = landLight(relative, lightSharesAt(pixel, relative));
  return endingLandThroughAir(light, relative, leftOfLight(relative));
}
