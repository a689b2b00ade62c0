// The stored normal of a patch's vertex.
#include "terrain/patch.glsl"

layout(binding = 1) uniform sampler2DArray chunkNormals;

vec3 patchNormal(int vertex) {
  ivec2 place = min(vertexSample(vertex), kChunkCells) + kNormalMargin;
  vec2 e = (texelFetch(chunkNormals, ivec3(place, patchPlace.z), 0).rg * 255.0 - 128.0) / 127.0;
  vec2 xz = vec2(e.x + e.y, e.x - e.y) * 0.5;
  return normalize(vec3(xz.x, 1.0 - abs(xz.x) - abs(xz.y), xz.y));
}
