// A fixed pattern of +-0.5/255 that hides the steps of 8 bits in a smooth sky. A function of the pixel alone, so a
// frame stays a function of what is in it.
#include "shared/hash.glsl"

vec3 ditherStep(uvec2 pixel) {
  uvec2 bits = hash2(pixel);
  return vec3((unitOf(bits.x) - 0.5) / 255.0);
}
