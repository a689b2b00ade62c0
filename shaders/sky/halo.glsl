// Light that ice between the eye and the sky refracts: the halos of crystals of all orientations, and the sun dogs of level
// plates (assets/scripts/make_halo.py has what the tables are). Added to the sky.
#include "frame.glsl"
#include "sky/halo_phase.glsl"

uniform float iceDepth;     // upright optical depth of the ice above the eye
uniform float iceAboveM;    // of the eye

// The air lies before the ice in each direction, and frame.sunLight has it on the way from the light.
vec3 airAgainstThatOfLight(float slant, float slantOfLight) {
  vec3 here = airTransmittance(iceAboveM, iceAboveM * slant);
  vec3 there = airTransmittance(iceAboveM, iceAboveM * slantOfLight);
  return here / max(there, vec3(1e-4));
}

vec3 haloTowards(vec3 direction) {
  float degrees = angleBetween(direction, frame.toSun.xyz) / kDegree;
  if (degrees > kHaloTo || direction.y < seaEndsSine()) return vec3(0.0);
  float slant = iceSlant(direction.y, iceAboveM);
  vec3 phase = crystalPhase(direction, degrees);
  vec3 light = frame.sunLight.xyz * airAgainstThatOfLight(slant, iceSlant(frame.toSun.y, iceAboveM));
  return min(light * phase * iceScattering(iceDepth * slant), vec3(kBrightest));
}
