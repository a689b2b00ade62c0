// Normals and colours of the land at any place. After terrain/noise.glsl, shared/land_material.glsl and
// shadow/cast_shadows.glsl.

layout(binding = 1) uniform sampler2DArray chunkNormals;
layout(binding = 2) uniform usampler2D chunkTable;  // slots by level and place: 32 x 32 cells a level; 0xffff: none

uniform float chunkSplit[7];  // from this distance on the samples of a level are fine enough

const int kTopLevel = 6;
const int kTableSide = 32;
const uint kNoChunk = 0xffffu;

// The coarsest level of chunks whose samples are fine enough at a distance.
int levelAt(float distanceM) {
  int level = 0;
  for (int l = 1; l <= kTopLevel; ++l) level += distanceM >= chunkSplit[l] ? 1 : 0;
  return level;
}

vec3 unpackedNormal(vec2 unorm) {
  vec2 e = (unorm * 255.0 - 128.0) / 127.0;
  vec2 xz = vec2(e.x + e.y, e.x - e.y) * 0.5;
  return normalize(vec3(xz.x, 1.0 - abs(xz.x) - abs(xz.y), xz.y));
}

// Where the samples of a place (metres from the base) are: texel and layer; and how many metres a texel covers. From the
// finest chunk at hand that is not finer than the distance asks for; metres 0: none is at hand.
struct LandTexel {
  vec3 at;
  float metres;
};

LandTexel landTexel(vec2 place, float distanceM) {
  vec2 cell = floor(place / kChunkMetres);
  vec2 inside = place - cell * kChunkMetres;
  ivec2 chunk = baseChunk + ivec2(cell);
  int level = levelAt(distanceM);
  uint slot = kNoChunk;
  for (; level <= kTopLevel; ++level) {
    ivec2 entry = (chunk >> level) & (kTableSide - 1);
    slot = texelFetch(chunkTable, ivec2(entry.x, entry.y + level * kTableSide), 0).r;
    if (slot != kNoChunk) break;
  }
  if (slot == kNoChunk) return LandTexel(vec3(0.0), 0.0);
  vec2 sampleAt = (vec2(chunk & ((1 << level) - 1)) * 240.0 + inside * 0.25) / float(1 << level);
  return LandTexel(vec3(sampleAt, float(slot)), float(4 << level));
}

vec3 normalAt(LandTexel texel, vec2 aside) {
  return unpackedNormal(texture(chunkNormals, vec3((texel.at.xy + aside + 0.5) / 241.0, texel.at.z)).rg);
}

// The normal of the land at a place (metres from the base).
vec3 landNormal(vec2 place, float distanceM) {
  LandTexel texel = landTexel(place, distanceM);
  return texel.metres > 0.0 ? normalAt(texel, vec2(0.0)) : vec3(0.0, 1.0, 0.0);
}

// How much the normals diverge over 24 m (or a texel, where that is wider): ridges positive, hollows negative. Sums of
// two neighbours on each axis; at a chunk's border the last sample stands for the one outside.
float landCurvature(LandTexel texel) {
  if (texel.metres <= 0.0) return 0.0;
  float aside = max(24.0 / texel.metres, 1.0);
  vec2 east = vec2(aside, 0.0);
  return 0.5 * (normalAt(texel, east).x - normalAt(texel, -east).x + normalAt(texel, east.yx).z -
                normalAt(texel, -east.yx).z);
}

const float kTreeMetres = 8.0;  // between trees
const float kClodMetres = 8.0;
const float kGrainMetres = 1.333;

// Light from the land (or the sea's floor) at a place `relative` to the eye, without what lies between.
vec3 landLight(vec3 relative) {
  float distanceM = length(relative);
  vec2 place = eyeFromBase.xz + relative.xz;
  float heightM = eyeFromBase.y + relative.y;
  LandTexel texel = landTexel(place, distanceM);
  vec3 normal = texel.metres > 0.0 ? normalAt(texel, vec2(0.0)) : vec3(0.0, 1.0, 0.0);
  // What a pixel covers, wider where the land is seen at a slant.
  float facing = clamp(-dot(normal, relative) / distanceM, 0.25, 1.0);
  float footprint = distanceM * frame.depthToSea.w / sqrt(facing);

  vec2 wide = noiseAt(place, 1), middle = turnedNoiseAt(place, 1), fine = noiseAt(place, 24);
  float middleShare = resolved(192.0, footprint), fineShare = resolved(40.0, footprint);
  vec4 clod = spaceNoiseAt(place, heightM, 120) * resolved(kClodMetres, footprint);
  vec4 grain = spaceNoiseAt(place, heightM, 720) * resolved(kGrainMetres, footprint);
  LandNoise noise;
  noise.region = wide.x * 0.7 + middle.y * 0.3 * middleShare;
  noise.grove = (middle.x * 0.65 + fine.y * 0.35 * fineShare) * middleShare;
  noise.tuft = fine.x * fineShare;
  noise.clod = clod.w;
  noise.grain = grain.w;

  uvec2 cell;
  vec2 inside;
  latticeOf(place, int(kChunkMetres / kTreeMetres), cell, inside);
  Crowns crowns = crownsAt(cell, inside);
  float treeShare = resolved(kTreeMetres, footprint);
  vec2 strata = rockStrata(heightM, 22.0 * noise.grove + 9.0 * noise.tuft, footprint);

  LandSurface land = landSurface(heightM, normal.y, landCurvature(texel), noise, strata.x, crowns, treeShare);

  // Detail as slope: of clods and grains, of ledges where the rock is bare, of the trees' crowns.
  vec3 slope = (clod.xyz * (0.10 * kClodMetres) + grain.xyz * (0.18 * kGrainMetres)) * land.roughness +
               vec3(0.0, strata.y * 3.0 * smoothstep(0.85, 0.6, normal.y), 0.0);
  slope = mix(slope, vec3(crowns.slope.x, 0.0, crowns.slope.y) * (0.55 * treeShare), land.wooded);
  vec3 bumped = normalize(normal - (slope - normal * dot(slope, normal)));

  float up = 0.5 + 0.5 * bumped.y;
  vec3 light = frame.sunLight.xyz * (max(dot(bumped, frame.toSun.xyz), 0.0) * castShadowShare(relative)) +
               mix(frame.groundLight.xyz, frame.skyLight.xyz, up) * land.open;
  return land.albedo / kPi * light;
}

vec3 landAsSeen(vec3 relative) {
  return mix(horizonRadiance(normalize(relative)), throughHaze(landLight(relative), relative), leftOfLight(relative));
}
