#include "terrain/patch.glsl"
#include "sea_cut.glsl"

void main() {
  vec3 relative = patchVertex(gl_VertexID);
  gl_Position = frame.viewProjection * vec4(relative, 1.0);
  cutBelowSea(relative);
}
