// Rain and snow on the land (render::FallenWater); programs are compiled with FALLEN_WATER in frames that have some.
const vec3 kFallenSnow = vec3(0.74, 0.77, 0.81);  // albedo

#ifdef FALLEN_WATER
#include "shared/precipitation.glsl"

uniform vec4 fallen;     // wet and snowed [0, 1], height of the snow line (m)
uniform vec4 fallenSky;  // rgb: radiance that puddles mirror

const float kPuddleF0 = 0.02;  // of water, seen straight down

// What it makes of a surface, and how much of the sky it mirrors towards the eye beside the surface's own light.
struct Fallen {
  LandSurface land;
  float mirrors;
};

vec3 mirroredSky(Fallen lying, vec3 lightShares) {
  return (fallenSky.xyz * lightShares.y + diffuseSunTowards(vec3(0.0, 1.0, 0.0), lightShares)) * lying.mirrors;
}

Fallen fallenOn(LandSurface land, float heightM, vec3 normal, LandNoise noise, vec3 toEye) {
  float drift = driftNoise(noise);
  float snow = fallenSnow(fallen.y, heightM, fallen.z, normal.y, drift) * (1.0 - 0.35 * land.wooded);
  float wet = fallen.x * (1.0 - snow);
  float puddle = puddleShare(wet, normal.y, drift) * (1.0 - land.wooded);
  vec3 dark = vec3(wetAlbedo(land.albedo.x), wetAlbedo(land.albedo.y), wetAlbedo(land.albedo.z));
  Fallen result;
  result.land = land;
  result.land.albedo = mix(mix(land.albedo, dark, wet), kFallenSnow * (1.0 + 0.05 * noise.tuft), snow);
  result.land.albedo *= 1.0 - 0.5 * puddle;
  result.land.roughness = mix(land.roughness, 0.15, snow);
  // A film mirrors a little everywhere, puddles all that water does (Schlick 1994).
  float aside = 1.0 - saturate(dot(normal, toEye));
  float fresnel = kPuddleF0 + (1.0 - kPuddleF0) * aside * aside * aside * aside * aside;
  result.mirrors = fresnel * (0.25 * wet * (1.0 - land.wooded) + 0.75 * puddle);
  return result;
}
#endif
