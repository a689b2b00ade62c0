// Takes what rays lose from the scene.
#include "shafts/blend.glsl"
#include "shafts/scene.glsl"

layout(binding = 1) uniform sampler2D filtered;

// The loss by opacity is that of the four texels around a pixel, those more whose rays end where its does.
vec3 lossOf(ivec2 pixel) {
  vec3 ray = rayOf(pixel);
  float rayScale = length(ray);
  vec3 opacity = airOpacity(ray.y / rayScale, sceneDistance(pixel, rayScale), cloudsIn(pixel));
  vec2 at = vec2(pixel - spacing / 2) / float(spacing);
  ivec2 low = ivec2(floor(at)), last = textureSize(filtered, 0) - 1;
  vec2 share = at - vec2(low);
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 4; ++i) {
    ivec2 corner = ivec2(i & 1, i >> 1);
    vec4 one = texelFetch(filtered, clamp(low + corner, ivec2(0), last), 0);
    vec2 weight = mix(1.0 - share, share, vec2(corner));
    sum += vec4(one.rgb, 1.0) * ((weight.x * weight.y + 1e-3) * likeness(one.a, opacity.g, 0.02));
  }
  return sum.rgb / sum.a * opacity;
}

// The air's light cannot fall below none.
vec3 withoutLoss(vec3 light, vec3 loss) { return min(max(light - loss, min(light, vec3(0.0))), vec3(kBrightest)); }
