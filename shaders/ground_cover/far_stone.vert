#include "ground_cover/far_stone.glsl"
#include "sea_cut.glsl"

flat out vec3 light;

void main() {
  StoneVertex vertex = stoneVertex();
  gl_Position = frame.viewProjection * vec4(vertex.relative, 1.0);
  cutBelowSea(vertex.relative);
  light = lightOfFarStone(vertex);
}
