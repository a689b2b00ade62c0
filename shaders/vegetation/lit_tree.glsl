// Light of a tree's foliage and bark, and what of a tree is drawn at a pixel.
#include "frame.glsl"

// The light of an instance as its fragments need it.
struct TreeLight {
  vec3 sun, above, below, air;
};

// Radiance of a surface in the crown: `open` dims what comes from the sky, `sunny` what comes from the sun. Leaves let some
// light through, so the sun's reaches round their edge.
vec3 treeRadiance(TreeLight light, vec3 normal, float open, float sunny, vec3 hue) {
  float facing = dot(normal, frame.toSun.xyz);
  float straight = max(facing, 0.0) * 0.85 + saturate(0.35 * facing + 0.35) * 0.35;
  float up = 0.5 + 0.5 * normal.y;
  return (light.sun * (straight * sunny) + mix(light.below, light.above, up) * open) * hue + light.air;
}

// In [0, 1), the same at a pixel in every frame: any share of the pixels is spread evenly (interleaved gradient noise:
// Jimenez, "Next generation post processing in Call of Duty", 2014). `own` moves it for each tree.
float ditherOf(vec2 pixel, float own) {
  return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))) + own);
}
