#include "places/house_look.glsl"

in vec3 local;
in vec3 relative;
flat in vec3 faceNormal;
flat in vec4 face;
flat in vec4 form;
flat in vec4 lightSun, lightAbove, lightBelow, lightAir;
out vec4 color;

void main() {
  if (placeDither(gl_FragCoord.xy, fract(face.z * 0.0137)) >= lightAbove.w) discard;
  HouseFace of = houseFace(local, relative, faceNormal, face, form, lightBelow.w);
  color = vec4(houseColor(of, faceNormal, relative, PlaceLight(lightSun.xyz, lightAbove.xyz, lightBelow.xyz, lightAir.xyz),
                          lightAir.w), 1.0);
}
