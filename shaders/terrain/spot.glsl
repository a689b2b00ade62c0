// The light of a lamp on the land (render::SpotLight); programs are compiled with SPOT_LIGHT in frames that have one.
#ifdef SPOT_LIGHT
#include "shared/lamp.glsl"

uniform vec3 spotPlace;  // relative to the eye
uniform vec4 spotAxis;   // unit, the way of the light; half angle (rad)
uniform vec3 spotLight;  // intensity

vec3 spotOn(vec3 relative, vec3 normal) {
  return spotLight * spotIlluminance(spotPlace - relative, normal, spotAxis.xyz, spotAxis.w);
}
#endif
