#include "terrain/vertex_normal.glsl"

out VertexOut {
  vec3 relative;
  vec3 normal;
} vertexOut;

void main() {
  vertexOut.relative = patchVertex(gl_VertexID);
  vertexOut.normal = patchNormal(gl_VertexID);
}
