// What ice clouds leave of the light at a place below them (include/skydrop/render/clouds/ice_shade.h).
#include "shared/ice_clouds.glsl"

layout(binding = 5) uniform sampler2D iceShadeMap;  // upright optical depth
uniform vec4 iceMapPlace;  // xy: from the map's corner to where the sun's ray through the eye meets the ice, m; zw: how far
                           // that is moved a metre upwards
uniform vec3 iceMapScale;  // 1 / the map's side; the sun's slant; the sun's light over the sky's

vec2 lightBelowIce(vec3 relative) {
  vec2 place = (iceMapPlace.xy + relative.xz - iceMapPlace.zw * relative.y) * iceMapScale.x;
  float depth = texture(iceShadeMap, place).x * iceMapScale.y;
  return vec2(iceSunLeft(depth), 1.0 + iceSpread(depth) * iceMapScale.z);
}
