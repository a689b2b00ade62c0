#include "vegetation/impostor_bake.glsl"

layout(location = 0) in vec3 unitPlace;
layout(location = 1) in vec3 unitNormal;
layout(location = 2) in vec2 unitSurface;

out vec3 crownPlace;
out vec3 surfaceNormal;
out vec2 surface;

void main() {
  gl_Position = bakedPosition(unitPlace);
  crownPlace = unitPlace;
  surfaceNormal = unitNormal;
  surface = unitSurface;
}
