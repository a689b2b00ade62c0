// The light of a flash of lightning (render::FlashLight); programs are compiled with FLASH_LIGHT in frames that have one.
#ifdef FLASH_LIGHT
#include "shared/flash.glsl"

const int kFlashLights = 8;
uniform vec4 flashPlaces[kFlashLights];  // relative to the eye; square of the length over which it is spread
uniform vec4 flashLights[kFlashLights];  // intensity; 1 in open air, 0 within a cloud

// Of a light's glitter on water, rad: the part of the channel that it stands for, seen from a kilometre or two.
const float kFlashGlitterRadius = 0.1;

vec3 flashTowards(int i, vec3 relative) { return normalize(flashPlaces[i].xyz - relative); }

vec3 flashOnFrom(int i, vec3 relative, vec3 normal) {
  return flashLights[i].xyz * flashIlluminance(flashPlaces[i].xyz - relative, normal, flashPlaces[i].w);
}

// Illuminance of a surface with a unit normal.
vec3 flashOn(vec3 relative, vec3 normal) {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < kFlashLights; ++i) sum += flashOnFrom(i, relative, normal);
  return sum;
}
#endif
