// The light of the listed pixels until all of it has been worked out: red and green by the list, blue in place of the pixel's
// shares, which nobody else reads.
#include "edges/shares.glsl"

layout(std430, binding = 2) buffer Lights { uint redGreen[]; };

void keepLight(uint index, ivec2 pixel, vec3 light) {
  redGreen[index] = packHalf2x16(light.rg);
  imageStore(shares, pixel, uvec4(packHalf2x16(vec2(light.b, 0.0))));
}

// And clears the shares for the next frame.
vec3 takeLight(uint index, ivec2 pixel) {
  vec3 light = vec3(unpackHalf2x16(redGreen[index]), unpackHalf2x16(imageLoad(shares, pixel).x).x);
  imageStore(shares, pixel, uvec4(0u));
  return light;
}
