// The sky with the sun's disc; below the horizon an endless plain of average land at sea level.
#include "frame.glsl"

// The sun's disc, its edge smoothed over a pixel; the horizon cuts it.
vec3 sunDisc(vec3 direction) {
  vec3 aside = cross(direction, frame.toSun.xyz);
  float pixels = (frame.toSun.w - sqrt(dot(aside, aside))) / frame.depthToSea.w;
  float above = direction.y / frame.depthToSea.w;
  float inDisc = clamp(pixels + 0.5, 0.0, 1.0) * clamp(above + 0.5, 0.0, 1.0);
  return dot(direction, frame.toSun.xyz) > 0.0 ? frame.sunDisc.xyz * inDisc : vec3(0.0);
}

// How much of the plain's light comes through the haze in a direction: none from above the horizon.
vec3 plainShare(vec3 direction) {
  if (direction.y >= 0.0) return vec3(0.0);
#ifdef HAZE
  return airTransmittanceToSea(direction);
#else
  return vec3(1.0);
#endif
}

vec3 skyInDirection(vec3 direction) {
  vec3 sky = mix(skyTowards(direction), frame.groundLight.xyz / kPi, plainShare(direction));
  return min(sky + sunDisc(direction), vec3(kBrightest));
}
