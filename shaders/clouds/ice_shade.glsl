// Upright optical depth of a layer of ice on a coarse map, smoothed over its texels (render::IceShadePass).
#include "clouds/ice_density.glsl"

uniform float iceDepth;  // of a density of 1
uniform float texelM;

float uprightIceDepth(vec2 texel) {
  IcePlace place = iceMoved(iceOrigin(), inIceAxes(texel * texelM));
  return iceDepth * 0.5 * (iceDensity(place, 0.25, vec2(texelM)) + iceDensity(place, 0.75, vec2(texelM)));
}
