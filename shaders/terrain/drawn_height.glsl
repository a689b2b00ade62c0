// The height of the land as it is drawn at a place, for what stands on it: the mesh of terrain/patch.glsl, without its
// vertices. Included after terrain/land.glsl.
#include "shared/terrain_lod.glsl"

layout(binding = 0) uniform usampler2DArray chunkHeights;
uniform vec2 heightRange;  // lowest, and metres a code
uniform float lodMorph[kTopPatchLevel + 1];

const int kRaisedChunks = 1 << 20;

// Of a sample, numbered at level 0 from the world's origin (wrapped as baseChunk is), from the finest chunk at hand that
// is not finer than `level`; below all land where there is none.
float storedHeightAt(ivec2 number, int level) {
  ivec2 raised = number + kChunkCells * kRaisedChunks;  // GLSL leaves the remainder of negative numbers open
  ivec2 chunk = raised / kChunkCells - kRaisedChunks;
  ivec2 inside = raised % kChunkCells;
  uint layer = kNoChunk;
  for (level = min(level, kMaxChunkLevel); level <= kMaxChunkLevel; ++level) {
    ivec2 entry = (chunk >> level) & (kChunkTableSide - 1);
    layer = texelFetch(chunkTable, ivec2(entry.x, entry.y + level * kChunkTableSide), 0).r;
    if (layer != kNoChunk) break;
  }
  if (layer == kNoChunk) return -1e6;
  ivec2 at = ((chunk & ((1 << level) - 1)) * kChunkCells + inside) >> level;
  return heightRange.x + heightRange.y * float(texelFetch(chunkHeights, ivec3(at, int(layer)), 0).r);
}

// On the mesh whose cells are 4 m << level, at a place (metres from the base).
float meshHeightAt(vec2 place, int level) {
  vec2 samples = place / kCellMetres;
  ivec2 number = baseChunk * kChunkCells + ivec2(floor(samples));
  ivec2 corner = (number >> level) << level;
  vec2 inside = (vec2(number - corner) + samples - floor(samples)) / float(1 << level);
  int stride = 1 << level;
  return meshHeight(storedHeightAt(corner, level), storedHeightAt(corner + ivec2(stride, 0), level),
                    storedHeightAt(corner + ivec2(0, stride), level), storedHeightAt(corner + ivec2(stride), level),
                    inside.x, inside.y);
}

// Above the sea, m; below -1e5 where no land is at hand.
float drawnHeight(vec2 place) {
  vec2 ground = place - eyeFromBase.xz;
  float first = meshHeightAt(place, int(lodLambda(length(ground), lodMorph)));
  float lambda = lodLambda(length(vec3(ground.x, first - eyeFromBase.y, ground.y)), lodMorph);
  int level = int(lambda);
  return mix(meshHeightAt(place, level), meshHeightAt(place, level + 1), lambda - float(level));
}
