#include "vegetation/impostor_baked.glsl"

in vec3 crownPlace;
in vec3 surfaceNormal;
in vec2 surface;
out vec4 texel;

void main() {
  texel = bakedTexel(crownPlace, surfaceNormal, surface);
  if (texel.a <= 0.0) discard;
}
