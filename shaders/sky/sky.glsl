// The sky with the sun's disc; below the horizon an endless plain of average land at sea level.
#include "frame.glsl"

// The sun's disc, its edge smoothed over a pixel; the horizon cuts it.
vec3 sunDisc(vec3 direction) {
  vec3 aside = cross(direction, frame.skySun.xyz);
  float pixels = (frame.skySun.w - sqrt(dot(aside, aside))) / frame.depthToSea.w;
  float above = (direction.y - seaEndsSine()) / frame.depthToSea.w;
  float inDisc = clamp(pixels + 0.5, 0.0, 1.0) * clamp(above + 0.5, 0.0, 1.0);
  return dot(direction, frame.skySun.xyz) > 0.0 ? frame.sunDisc.xyz * inDisc : vec3(0.0);
}

// SKY_ALONE: of directions above the level one.
vec3 skyInDirection(vec3 direction) {
#ifdef SKY_ALONE
  vec3 light = skyTowards(direction);
#else
  vec3 light = skyAndPlain(direction);
#endif
  return min(light + sunDisc(direction), vec3(kBrightest));
}
