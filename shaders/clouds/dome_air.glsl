// The air before the dome.
#include "frame.glsl"
#include "shared/cloud_sheet.glsl"

// Transmittance from the eye to the clouds of a direction.
vec3 domeAirLeft(vec3 direction) {
  float distanceM = domeDistance(direction.y, frame.eye.x);
  return airTransmittance(direction.y * distanceM, distanceM);
}
