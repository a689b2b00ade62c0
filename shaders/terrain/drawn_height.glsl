// The height of the land as it is drawn at a place, for what stands on it: the mesh of terrain/patch.glsl, without its
// vertices. Included after terrain/land.glsl.
#include "shared/terrain_lod.glsl"

layout(binding = 0) uniform usampler2DArray chunkHeights;
uniform vec2 heightRange;  // lowest, and metres a code
uniform float lodMorph[kTopPatchLevel + 1];

const int kRaisedChunks = 1 << 20;

// The corners of a cell of the mesh, and where in it a place is.
struct MeshCell {
  float nw, ne, sw, se;  // heights above the sea, m; below -1e5 where no land is at hand
  vec2 inside;           // [0, 1)
  float cellM;
};

// The cell of a place (metres from the base) on the mesh whose cells are 4 m << level, from the finest chunk at hand that is
// not finer. All four corners are samples of one chunk, which has those on its east and south border too.
MeshCell meshCellAt(vec2 place, int level) {
  vec2 samples = place / kCellMetres;
  ivec2 number = baseChunk * kChunkCells + ivec2(floor(samples));
  ivec2 corner = (number >> level) << level;
  ivec2 raised = corner + kChunkCells * kRaisedChunks;  // GLSL leaves the remainder of negative numbers open
  ivec2 chunk = raised / kChunkCells - kRaisedChunks;
  ivec2 first = raised % kChunkCells;
  int stride = 1 << level;
  uint layer = kNoChunk;
  int of = min(level, kMaxChunkLevel);
  for (; of <= kMaxChunkLevel; ++of) {
    ivec2 entry = (chunk >> of) & (kChunkTableSide - 1);
    layer = texelFetch(chunkTable, ivec2(entry.x, entry.y + of * kChunkTableSide), 0).r;
    if (layer != kNoChunk) break;
  }
  bool isThere = layer != kNoChunk;
  first += (chunk & ((1 << of) - 1)) * kChunkCells;
  ivec2 at = first >> of, next = (first + stride) >> of;
  int slice = isThere ? int(layer) : 0;
  vec4 codes = vec4(texelFetch(chunkHeights, ivec3(at, slice), 0).r, texelFetch(chunkHeights, ivec3(next.x, at.y, slice), 0).r,
                    texelFetch(chunkHeights, ivec3(at.x, next.y, slice), 0).r, texelFetch(chunkHeights, ivec3(next, slice), 0).r);
  vec4 heights = isThere ? heightRange.x + heightRange.y * codes : vec4(-1e6);
  return MeshCell(heights.x, heights.y, heights.z, heights.w, (vec2(number - corner) + samples - floor(samples)) / float(stride),
                  kCellMetres * float(stride));
}

float meshHeightAt(vec2 place, int level) {
  MeshCell cell = meshCellAt(place, level);
  return meshHeight(cell.nw, cell.ne, cell.sw, cell.se, cell.inside.x, cell.inside.y);
}

// Above the sea, m; below -1e5 where no land is at hand.
float drawnHeight(vec2 place) {
  vec2 ground = place - eyeFromBase.xz;
  float first = meshHeightAt(place, int(lodLambda(length(ground), lodMorph)));
  float lambda = lodLambda(length(vec3(ground.x, first - eyeFromBase.y, ground.y)), lodMorph);
  int level = int(lambda);
  return mix(meshHeightAt(place, level), meshHeightAt(place, level + 1), lambda - float(level));
}
