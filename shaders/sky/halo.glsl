// Light that ice between the eye and the sky refracts: the halos of crystals of all orientations, and the sun dogs of level
// plates (assets/scripts/make_halo.py has what the tables are). Added to the sky.
#include "frame.glsl"
#include "shared/atmospheric_optics.glsl"

layout(binding = 0) uniform sampler2D haloTable;
layout(binding = 1) uniform sampler3D sunDogTable;
uniform float iceDepth;     // upright optical depth of the ice above the eye
uniform float plates;       // share of it that lies level
uniform float iceAboveM;    // of the eye

const float kHaloFrom = 16.0, kHaloTo = 64.0;           // degrees
const float kDogFrom = -3.0, kDogTo = 21.0, kDogRise = 5.0;

vec3 haloPhase(float degrees) {
  float texels = float(textureSize(haloTable, 0).x);
  return textureLod(haloTable, vec2(texturePlace(degrees, kHaloFrom, kHaloTo, texels), 0.5), 0.0).xyz;
}

vec3 sunDogPhase(vec3 direction) {
  vec3 at = sunDogDegrees(direction, frame.toSun.xyz);
  vec3 texels = vec3(textureSize(sunDogTable, 0));
  vec3 place = vec3(texturePlace(at.x, kDogFrom, kDogTo, texels.x), texturePlace(at.y, -kDogRise, kDogRise, texels.y),
                    texturePlace(at.z, 0.0, kHighestSunDog, texels.z));
  return textureLod(sunDogTable, place, 0.0).xyz;
}

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
  vec3 phase = mix(haloPhase(degrees), sunDogPhase(direction), plates);
  vec3 light = frame.sunLight.xyz * airAgainstThatOfLight(slant, iceSlant(frame.toSun.y, iceAboveM));
  return min(light * phase * iceScattering(iceDepth * slant), vec3(kBrightest));
}
