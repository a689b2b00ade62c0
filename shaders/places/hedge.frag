#include "places/hedge_look.glsl"

in vec3 leafPlace;
in vec3 leafNormal;
in float open;
flat in vec4 lightSun, lightAbove, lightBelow, lightAir;
out vec4 color;

void main() {
  if (placeDither(gl_FragCoord.xy, fract(lightSun.w * 0.0137)) >= lightAbove.w) discard;
  color = vec4(hedgeColor(leafPlace, normalize(leafNormal), open, lightSun.w,
                          PlaceLight(lightSun.xyz, lightAbove.xyz, lightBelow.xyz, lightAir.xyz)), 1.0);
}
