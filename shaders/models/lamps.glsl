// Lamps near a model (render::ModelLamps): illuminance of a surface.
#include "shared/lamp.glsl"

const int kMostLamps = 6;
uniform vec4 lampPlaces[kMostLamps];  // relative to the eye
uniform vec4 lampLights[kMostLamps];  // intensity

vec3 lampsOn(vec3 relative, vec3 normal) {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < kMostLamps; ++i)
    sum += lampLights[i].xyz * lampIlluminance(lampPlaces[i].xyz - relative, normal);
  return sum;
}
