#include "places/house_mesh.glsl"
#include "sea_cut.glsl"

out vec3 local;
out vec3 relative;
flat out vec3 faceNormal;
flat out vec4 face;  // part, use, bits, length of the ridge
flat out vec4 form;
flat out vec4 lightSun, lightAbove, lightBelow, lightAir;

void main() {
  HouseVertex vertex = houseVertex();
  gl_Position = frame.viewProjection * vec4(vertex.relative, 1.0);
  cutBelowSea(vertex.relative);
  local = vertex.local;
  relative = vertex.relative;
  faceNormal = vertex.normal;
  face = vec4(vertex.part, placeTurn.w, placeSun.w, placeTurn.z);
  form = placeForm;
  lightSun = placeSun;
  lightAbove = placeAbove;
  lightBelow = placeBelow;
  lightAir = placeAir;
}
