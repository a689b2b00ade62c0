// What regular crystals scatter, by the tables of assets/scripts/make_halo.py.
#include "frame.glsl"
#include "shared/atmospheric_optics.glsl"

layout(binding = 0) uniform sampler2D haloTable;
layout(binding = 1) uniform sampler3D sunDogTable;
uniform float plates;       // share of the crystals that lie level

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

// Of all of them; none beyond kHaloTo.
vec3 crystalPhase(vec3 direction, float degrees) { return mix(haloPhase(degrees), sunDogPhase(direction), plates); }
