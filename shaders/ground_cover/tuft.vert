#include "ground_cover/plant.glsl"
#include "sea_cut.glsl"

out vec3 light;

void main() {
  PlantVertex vertex = tuftVertexAt();
  gl_Position = frame.viewProjection * vec4(vertex.relative, 1.0);
  cutBelowSea(vertex.relative);
  light = vertex.light;
}
