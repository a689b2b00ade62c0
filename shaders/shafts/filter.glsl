// Means the places of the steps of neighbours together: 5 x 5 texels, those at the sides half, so that each of the 4 x 4
// patterns of steps counts alike. What ends elsewhere counts less.
#include "shafts/blend.glsl"

layout(binding = 1) uniform sampler2D marched;

vec4 meanOfNeighbours(ivec2 texel) {
  ivec2 last = textureSize(marched, 0) - 1;
  float own = texelFetch(marched, texel, 0).a;
  vec4 sum = vec4(0.0);
  for (int y = -2; y <= 2; ++y) {
    for (int x = -2; x <= 2; ++x) {
      vec4 one = texelFetch(marched, clamp(texel + ivec2(x, y), ivec2(0), last), 0);
      float share = (abs(x) == 2 ? 0.5 : 1.0) * (abs(y) == 2 ? 0.5 : 1.0);
      sum += vec4(one.rgb, 1.0) * (share * likeness(one.a, own, 0.02));
    }
  }
  return vec4(sum.rgb / sum.a, own);
}
