// The lens of a lamp, and the veil around it.
#include "cloud_transmittance.glsl"
#include "models/lamps_seen.glsl"
#include "shared/lamp.glsl"

vec3 glowAt(int lamp, vec2 pixelsAside) {
  float square = dot(pixelsAside, pixelsAside);
  float degreesAside = degrees(frame.depthToSea.w);
  float spread = glowCores[lamp].w;
  vec3 light = glowCores[lamp].xyz * exp(-min(square / (2.0 * spread * spread), 60.0)) +
               glowVeils[lamp].xyz * glareShape(square * degreesAside * degreesAside, glowPlaces[lamp].w);
  return min(light * throughClouds(length(glowPlaces[lamp].xyz)), vec3(kBrightest));
}
