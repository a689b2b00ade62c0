// Density of the layer of ice that a program is compiled for: CIRRUS, CIRROSTRATUS or CIRROCUMULUS.
#include "shared/ice_clouds.glsl"

uniform ivec2 iceCell;   // of where places are counted from: cell of the widest lattice,
uniform vec2 iceInside;  // and where in it
uniform vec2 iceAlong;   // the layer's first axis, x and z
uniform vec3 iceForm;    // trail and hook (m), threshold

IcePlace iceOrigin() { return make_icePlace(uvec2(iceCell), iceInside); }

vec2 inIceAxes(vec2 level) { return vec2(dot(iceAlong, level), iceAlong.x * level.y - iceAlong.y * level.x); }

float iceDensity(IcePlace place, float depth, vec2 extent) {
  IceForm form = IceForm(iceForm.x, iceForm.y, iceForm.z);
#if defined(CIRRUS)
  return cirrusDensity(place, form, depth, extent);
#elif defined(CIRROSTRATUS)
  return cirrostratusDensity(place, form, depth, extent);
#else
  return cirrocumulusDensity(place, form, depth, extent);
#endif
}
