#include "places/hedge_mesh.glsl"
#include "sea_cut.glsl"

out vec3 leafPlace;
out vec3 leafNormal;
out float open;
flat out vec4 lightSun, lightAbove, lightBelow, lightAir;

void main() {
  HedgeVertex vertex = hedgeVertex();
  gl_Position = frame.viewProjection * vec4(vertex.relative, 1.0);
  cutBelowSea(vertex.relative);
  leafPlace = vertex.unit;
  leafNormal = vertex.normal;
  open = unitNormal.w;
  lightSun = placeSun;
  lightAbove = placeAbove;
  lightBelow = placeBelow;
  lightAir = placeAir;
}
