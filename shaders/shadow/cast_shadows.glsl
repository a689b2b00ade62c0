// What is left of the sun behind an aircraft or a package (include/skydrop/render/shadows/cast_shadows.h).
#include "frame.glsl"

layout(binding = 9) uniform sampler2D shadowMap;
uniform vec4 casterMiddle;  // relative to the eye; 1 / half the map's width
uniform vec4 casterRight;   // the map's axis; the caster's radius
uniform vec4 casterUp;      // the map's axis; where the shadow has faded away

const float kShadowMapTexels = 256.0;
const int kSunTaps = 12;
const float kGoldenAngle = 2.39996323;

// Where a place `relative` to the eye lies behind the caster.
struct BehindCaster {
  float metres;    // from the caster's middle
  vec2 place;      // on the map; its half width is 1
  float sunReach;  // radius of the sun's disc as seen from there, on the map
  float pixel;     // width of a pixel there, on the map
};
BehindCaster behindCaster(vec3 relative) {
  vec3 from = relative - casterMiddle.xyz;
  float behind = -dot(from, frame.toSun.xyz);
  vec2 place = vec2(dot(from, casterRight.xyz), dot(from, casterUp.xyz)) * casterMiddle.w;
  return BehindCaster(behind, place, max(behind, 0.0) * tan(frame.toSun.w) * casterMiddle.w,
                      length(relative) * frame.depthToSea.w * casterMiddle.w);
}

// Whether any of the sun can be hidden there: CastShadow::halfWidthM.
bool mayBeInShadow(BehindCaster at) {
  float halfWidth = 1.0 + at.sunReach + at.pixel;
  return at.metres > -casterRight.w && at.metres < casterUp.w && max(abs(at.place.x), abs(at.place.y)) < halfWidth;
}

// The mean of the map over a disc: of radius `reach` in texture coordinates, at equal areas on a spiral (Vogel 1979),
// each as wide as its share of the disc, and not finer than `texel`.
float meanOverSun(vec2 middle, float reach, float texel) {
  float share = reach * sqrt(kPi / float(kSunTaps));
  float lod = log2(max(max(share, texel) * kShadowMapTexels, 1.0));
  float sum = 0.0;
  for (int i = 0; i < kSunTaps; ++i) {
    float angle = kGoldenAngle * float(i);
    vec2 offset = vec2(cos(angle), sin(angle)) * (reach * sqrt((float(i) + 0.5) / float(kSunTaps)));
    sum += textureLod(shadowMap, middle + offset, lod).r;
  }
  return sum / float(kSunTaps);
}

// The share of the sun's disc that is left there.
float shareOfSun(BehindCaster at) {
  float left = 1.0 - smoothstep(0.6 * casterUp.w, casterUp.w, at.metres);
  return 1.0 - left * meanOverSun(at.place * 0.5 + 0.5, at.sunReach * 0.5, at.pixel * 0.5);
}
