// Light in clouds that was scattered before it comes to a place. LIGHT_VOLUME: from the texture of
// src/render/clouds/light_volumes.h; else from the octaves of the sun's light and from the height.
#include "clouds/field.glsl"

// Of a ray, for scatteredLightAt().
vec4 phasesOf(vec3 direction) {
  float cosine = dot(direction, frame.toSun.xyz);
#ifdef LIGHT_VOLUME
  return volumePhases(cosine, clouds.scattering.x, clouds.scattering.y);
#else
  return cloudPhases(cosine, clouds.scattering.x, clouds.scattering.y);
#endif
}

#ifdef LIGHT_VOLUME
layout(binding = 4) uniform sampler3D lightVolumes;  // x, rows of all layers, z: sun, sky

const float kVolumeRows = 16.0;  // of a layer, as clouds::LightVolume has them

#ifdef LAYERS
const float kVolumeLayers = float(LAYERS);
#else
const float kVolumeLayers = 1.0;
#endif

// Mean radiance from sun, sky and ground, per illuminance of each, at a place in periods of the weather's map.
vec3 meanLight(vec2 periods, float height, float layer) {
  float row = clamp(height * kVolumeRows, 0.5, kVolumeRows - 0.5) + layer * kVolumeRows;
  vec2 light = textureLod(lightVolumes, vec3(periods.x, row / (kVolumeRows * kVolumeLayers), periods.y), 0.0).xy;
  return vec3(light, groundOfVolume(light.y));
}
#endif

#ifdef LAYERS
#ifdef LIGHT_VOLUME
// Extinction there, and depth towards the sun in layers above: they shade what the volume of the place's own layer knows
// nothing of.
vec3 scatteredLightAt(vec3 place, vec4 phases, float depth, float above, float extinction) {
  vec3 sun = vec3(0.0);
  vec3 ambient = vec3(0.0);
  float sum = 0.0;
  float scatteredBefore = 0.0;
  float rowM = 0.0;
#define LIGHT(i)                                                                                           \
  {                                                                                                        \
    CloudLayer l = clouds.layers[i];                                                                       \
    float height = heightIn(l, place);                                                                     \
    float weight = layerWeight(height);                                                                    \
    vec3 mean = meanLight(l.weatherPlace.xz + place.xz * l.weatherPlace.w, height, float(i));              \
    sum += weight;                                                                                         \
    sun += weight * l.sunLight.xyz;                                                                        \
    rowM += weight * l.shell.y / kVolumeRows;                                                              \
    scatteredBefore += weight * mean.x;                                                                    \
    ambient += weight * (l.skyLight.xyz * mean.y + l.groundLight.xyz * mean.z);                            \
  }
  EACH_LAYER(LIGHT)
#undef LIGHT
  float before = scatteredBefore / sum * sunBelowCloud(above);
  float light = scatteredSunOfVolume(phases, depth, before, extinction, rowM / sum);
  return (sun * (light * sunOverLand(place)) + ambient) / sum;
}
#else
vec3 scatteredLightAt(vec3 place, vec4 phases, float depth) {
  SourceLight light = sourceLightAt(place);
  return light.sun * (scatteredSun(phases, depth) * sunOverLand(place)) + light.ambient;
}
#endif
#else
// Of sun, sky and ground, per illuminance of each; without the land's shade.
#ifdef LIGHT_VOLUME
vec3 scatteredLightAt(vec3 place, float height, vec4 phases, float depth, float extinction) {
  vec3 mean = meanLight(clouds.weatherPlace.xz + place.xz * clouds.weatherPlace.w, height, 0.0);
  float rowM = clouds.layer.y / kVolumeRows;
  return vec3(scatteredSunOfVolume(phases, depth, mean.x, extinction, rowM), mean.yz);
}
#else
vec3 scatteredLightAt(float height, vec4 phases, float depth) {
  return vec3(scatteredSun(phases, depth), scatteredSky(height), scatteredGround(height));
}
#endif
#endif
