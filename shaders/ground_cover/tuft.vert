#include "ground_cover/plant.glsl"

out vec3 light;

void main() {
  PlantVertex vertex = tuftVertexAt();
  gl_Position = frame.viewProjection * vec4(vertex.relative, 1.0);
  light = vertex.light;
}
