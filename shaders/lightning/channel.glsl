// Light of a piece of a channel at a pixel beside it.
#include "cloud_transmittance.glsl"
#include "frame.glsl"
#include "models/scene_depth.glsl"
#include "shared/flash.glsl"

// most: of a piece's radiance that is shown.
vec3 channelAt(vec2 pixels, float pixelsLong, vec3 radiance, float spread, float distanceM, float most) {
  float aside = exp(-min(pixels.y * pixels.y / (2.0 * spread * spread), 60.0));
  float along = flashAlong(pixels.x, spread) - flashAlong(pixels.x - pixelsLong, spread);
  vec3 light = radiance * (aside * max(along, 0.0));
  float brightest = max(max(light.x, max(light.y, light.z)), 1e-20);
  return light * (flashAtMost(brightest, most) / brightest * throughClouds(distanceM));
}
