// How long steps of a ray are: whole multiples of the step, so neighbouring rays are cut at the same distances and nothing
// drifts.
#include "clouds/uniforms.glsl"

// Length of a step: doubles as often as the distance does, so that multiples stay exact.
float stepAt(float distanceM) {
  float times = max(distanceM / clouds.march.y, 1.0);
  return clouds.march.x * intBitsToFloat(floatBitsToInt(times) & 0x7f800000);
}

// The last multiple of so many steps before a distance.
float alignedBefore(float distanceM, float steps) {
  float step = stepAt(distanceM) * steps;
  return floor(distanceM / step) * step;
}
