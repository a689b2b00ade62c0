// The vertices of the patches of land (include/skydrop/terrain/terrain_frame.h): heights from the chunks' textures,
// levels of detail from the distance.
#include "frame.glsl"
#include "shared/terrain_lod.glsl"

layout(location = 0) in ivec4 patchPlace;   // north-west corner in metres from the base: x, z; layer; level
layout(location = 1) in ivec4 patchSource;  // its sample in the chunk: x, z; the chunk's level; coarser edges, 4 bits each
layout(binding = 0) uniform usampler2DArray chunkHeights;

uniform vec3 eyeFromBase;  // x, z: metres from the base; y: height above the sea
uniform vec2 heightRange;  // lowest, and metres a code (include/skydrop/terrain/height_range.h)
uniform float lodMorph[kTopPatchLevel + 1];

const int kPatchSide = kPatchCells + 1;  // vertices

float storedHeight(ivec2 place) {
  uint code = texelFetch(chunkHeights, ivec3(min(place, kChunkCells), patchPlace.z), 0).r;
  return heightRange.x + heightRange.y * float(code);
}

// The height at a sample on the mesh whose cells are `stride` samples wide.
float heightOnMesh(ivec2 place, int stride) {
  ivec2 corner = place & ~(stride - 1);
  vec2 inside = vec2(place - corner) / float(stride);
  return meshHeight(storedHeight(corner), storedHeight(corner + ivec2(stride, 0)),
                    storedHeight(corner + ivec2(0, stride)), storedHeight(corner + ivec2(stride)), inside.x, inside.y);
}

int coarserBy(int edge) { return (patchSource.w >> (4 * edge)) & 15; }

// The sample of the chunk that a vertex stands on: its own, or on a border one that the neighbour has too.
ivec2 vertexSample(int vertex) {
  ivec2 corner = ivec2(vertex % kPatchSide, vertex / kPatchSide);
  int step = patchPlace.w - patchSource.z;
  ivec2 place = (patchSource.xy >> step) + corner;
  ivec2 snapped = place;
  if (corner.x == 0) snapped.y = snapDown(place.y, coarserBy(0));
  if (corner.x == kPatchSide - 1) snapped.y = snapDown(place.y, coarserBy(1));
  if (corner.y == 0) snapped.x = snapUp(place.x, coarserBy(2));
  if (corner.y == kPatchSide - 1) snapped.x = snapUp(place.x, coarserBy(3));
  return snapped << step;
}

// A vertex relative to the eye. All that both sides of a border compute from is whole numbers, exact in float, and
// the eye: so both sides get the same bits.
vec3 patchVertex(int vertex) {
  ivec2 place = vertexSample(vertex);
  ivec2 metres = patchPlace.xy + (place - patchSource.xy) * (4 << patchSource.z);
  vec2 ground = vec2(metres) - eyeFromBase.xz;
  float exact = storedHeight(place) - eyeFromBase.y;
  float lambda = lodLambda(length(vec3(ground.x, exact, ground.y)), lodMorph);
  int level = max(int(lambda), patchSource.z);
  int stride = 1 << (level - patchSource.z);
  float fine = heightOnMesh(place, stride);
  float coarse = heightOnMesh(place, 2 * stride);
  float height = fine + (coarse - fine) * max(lambda - float(level), 0.0);
  return vec3(ground.x, height - eyeFromBase.y, ground.y);
}
