// Light of a building's or a hedge's surface.
#include "frame.glsl"

struct PlaceLight {
  vec3 sun, above, below, air;
};

vec3 placeRadiance(PlaceLight light, vec3 albedo, vec3 normal, float open, float sunny) {
  float up = 0.5 + 0.5 * normal.y;
  return albedo * (light.sun * (max(dot(normal, frame.toSun.xyz), 0.0) * sunny) + mix(light.below, light.above, up) * open) +
         light.air;
}

// In [0, 1), the same at a pixel in every frame: any share of the pixels is spread evenly (interleaved gradient noise:
// Jimenez, "Next generation post processing in Call of Duty", 2014). `own` moves it for each instance.
float placeDither(vec2 pixel, float own) {
  return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))) + own);
}
