// From what a ray gathered to the light that reaches the eye.
#include "clouds/gathered.glsl"
#include "clouds/uniforms.glsl"

// Radiance of a cloud whose light comes from a distance, through the air before it: what is far away becomes the sky
// behind it.
vec3 throughAir(vec3 light, float opacity, vec3 direction, float distanceM) {
#ifdef HAZE
  vec3 left = airTransmittance(direction.y * distanceM, distanceM);
  return light * left + airBeforeSky(direction, distanceM, left) * opacity;
#else
  return light;
#endif
}

// rgb: radiance; a: what comes through of the light behind.
vec4 seenCloud(Gathered gathered, vec3 direction) {
  float transmittance = gathered.transmittance > clouds.march.w ? gathered.transmittance : 0.0;
  float whole = (1.0 - transmittance) / max(1.0 - gathered.transmittance, 1e-6);
#ifdef LAYERS
  vec3 light = gathered.light;
#else
  vec3 light = clouds.sunLight.xyz * gathered.sun + clouds.skyLight.xyz * gathered.sky + clouds.groundLight.xyz * gathered.ground;
#endif
  float distanceM = gathered.distance / max(gathered.weight, 1e-20);
  vec3 seen = throughAir(light * whole, 1.0 - transmittance, direction, distanceM);
  return vec4(min(seen, vec3(kBrightest)), transmittance);
}

// Mean distance of the light.
float seenDistance(Gathered gathered) {
  return gathered.weight > 0.0 ? min(gathered.distance / gathered.weight, kFarDistance) : kFarDistance;
}
