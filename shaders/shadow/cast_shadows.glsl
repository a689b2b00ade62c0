// What is left of the sun behind aircraft and packages (include/skydrop/render/cast_shadows.h). After frame.glsl.
// CAST_SHADOWS: how many there are; without it nothing casts one.
#ifdef CAST_SHADOWS
layout(binding = 9) uniform sampler2D shadowMaps[CAST_SHADOWS];
uniform vec4 castShadows[3 * CAST_SHADOWS];  // middle, 1 / half width; right, radius; up, reach

const float kShadowMapTexels = 256.0;
const int kSunTaps = 12;
const float kGoldenAngle = 2.39996323;

// The mean of a map over a disc: of radius `reach` in texture coordinates, at equal areas on a spiral (Vogel 1979),
// each as wide as its share of the disc, and not finer than `texel`.
float meanOverSun(sampler2D map, vec2 middle, float reach, float texel) {
  float share = reach * sqrt(kPi / float(kSunTaps));
  float lod = log2(max(max(share, texel) * kShadowMapTexels, 1.0));
  float sum = 0.0;
  for (int i = 0; i < kSunTaps; ++i) {
    float angle = kGoldenAngle * float(i);
    vec2 offset = vec2(cos(angle), sin(angle)) * (reach * sqrt((float(i) + 0.5) / float(kSunTaps)));
    sum += textureLod(map, middle + offset, lod).r;
  }
  return sum / float(kSunTaps);
}

float hiddenBy(sampler2D map, vec4 middle, vec4 right, vec4 up, vec3 relative) {
  vec3 from = relative - middle.xyz;
  float behind = -dot(from, frame.toSun.xyz);
  vec2 place = vec2(dot(from, right.xyz), dot(from, up.xyz)) * middle.w;
  float sunReach = max(behind, 0.0) * tan(frame.toSun.w) * middle.w;
  float texel = length(relative) * frame.depthToSea.w * middle.w;
  float left = step(-right.w, behind) * (1.0 - smoothstep(0.6 * up.w, up.w, behind));
  return left * meanOverSun(map, place * 0.5 + 0.5, sunReach * 0.5, texel * 0.5);
}

// The share of the sun's disc that a place `relative` to the eye sees.
float castShadowShare(vec3 relative) {
  float share = 1.0 - hiddenBy(shadowMaps[0], castShadows[0], castShadows[1], castShadows[2], relative);
#if CAST_SHADOWS > 1
  share *= 1.0 - hiddenBy(shadowMaps[1], castShadows[3], castShadows[4], castShadows[5], relative);
#endif
#if CAST_SHADOWS > 2
  share *= 1.0 - hiddenBy(shadowMaps[2], castShadows[6], castShadows[7], castShadows[8], relative);
#endif
#if CAST_SHADOWS > 3
  share *= 1.0 - hiddenBy(shadowMaps[3], castShadows[9], castShadows[10], castShadows[11], relative);
#endif
  return share;
}
#else
float castShadowShare(vec3 relative) { return 1.0; }
#endif
