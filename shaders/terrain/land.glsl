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

// The normal of the land at a place (metres from the base), from the finest chunk at hand that is not finer than the
// distance asks for.
vec3 landNormal(vec2 place, float distanceM) {
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
  if (slot == kNoChunk) return vec3(0.0, 1.0, 0.0);
  vec2 sampleAt = (vec2(chunk & ((1 << level) - 1)) * 240.0 + inside * 0.25) / float(1 << level);
  return unpackedNormal(texture(chunkNormals, vec3((sampleAt + 0.5) / 241.0, float(slot))).rg);
}

LandNoise landNoise(vec2 place, float footprint) {
  vec2 wide = noiseAt(place, 1), middle = turnedNoiseAt(place, 1), fine = noiseAt(place, 24),
       grain = turnedNoiseAt(place, 40);
  float middleShare = resolved(192.0, footprint), fineShare = resolved(40.0, footprint);
  LandNoise noise;
  noise.region = wide.x * 0.7 + middle.y * 0.3 * middleShare;
  noise.grove = (middle.x * 0.65 + fine.y * 0.35 * fineShare) * middleShare;
  noise.tuft = fine.x * fineShare;
  noise.grain = grain.x * resolved(4.8, footprint);
  return noise;
}

// Light from the land (or the sea's floor) at a place `relative` to the eye, without what lies between.
vec3 landLight(vec3 relative) {
  float distanceM = length(relative);
  vec2 place = eyeFromBase.xz + relative.xz;
  vec3 normal = landNormal(place, distanceM);
  LandNoise noise = landNoise(place, distanceM * frame.depthToSea.w);
  return litByFrame(landAlbedo(eyeFromBase.y + relative.y, normal.y, noise), normal, castShadowShare(relative));
}

vec3 landAsSeen(vec3 relative) {
  return mix(horizonRadiance(normalize(relative)), throughHaze(landLight(relative), relative), leftOfLight(relative));
}
