// Light and opacity of a cloud plane at a place, multiplied together, as if nothing stood before it.
#include "clouds/sheet_light.glsl"

layout(binding = 0) uniform sampler2D noise;
uniform float cutoff;
uniform float variation;   // how far the second copy shifts the cutoff
uniform float noiseMean;
uniform float detail;      // share of the fine copy
uniform float fineScale;   // how much finer it is
uniform float mostShift;   // of the cutoff
uniform float texels;      // along a side of the texture
uniform vec4 lost;         // standard deviation of the noise within a texel of the levels 2, 4, 6, 8
uniform vec2 towardsSun;   // in texture coordinates: where the shade of a place comes from

const float kNearFadeM = 250.0;   // closer than this to the eye a sheet thins out, instead of cutting the picture in two
// Standard deviations of noise over which the cut is softened: of what is seen, and of the shade.
const float kSoftCut = 0.011, kShadeBlur = 0.03;

// Levels of the texture by which a pixel is wider than a texel.
float footprintLevel(vec2 place) {
  vec2 across = dFdx(place) * texels, up = dFdy(place) * texels;
  return max(0.5 * log2(max(max(dot(across, across), dot(up, up)), 1e-12)), 0.0);
}

// Standard deviation of the noise within a texel of a level, between the levels that are known.
float lostAt(float level) {
  vec4 share = clamp(vec4(level) * 0.5 - vec4(0.0, 1.0, 2.0, 3.0), 0.0, 1.0);
  return dot(share, lost - vec4(0.0, lost.xyz));
}

vec4 planeLight(vec3 relative, vec2 place, vec2 weatherPlace, vec2 finePlace, float rim, vec3 airLeft) {
  float level = max(footprintLevel(place) - 1.0, 0.0);
  float spread = lostAt(level);
  float shift = clamp(variation * (textureLod(noise, weatherPlace, max(level - 2.0, 1.0)).r - noiseMean), -mostShift, mostShift);
  float cut = cutoff + shift;
  float fine = detail * (textureLod(noise, finePlace, level + log2(fineScale)).r - noiseMean);
  float here = textureLod(noise, place, level).r + fine;
  SheetCover cover = sheetCover(here, max(spread, kSoftCut), cut, depthPerNoise);
  float distanceM = length(relative);
  vec3 direction = relative / max(distanceM, 1e-3);
  float opacity = sheetCoverOpacity(cover, sheetPath(direction.y));
  opacity *= smoothstep(0.0, 1.0, rim) * smoothstep(0.0, kNearFadeM, distanceM);
  float shade = meanDepth(textureLod(noise, place + towardsSun, max(level, 1.5)).r - cut, max(spread, kShadeBlur));
  vec3 light = sheetLight(direction, cover.depth, shade, relative.y < 0.0 ? 1.0 : 0.0, sheetSunShare(relative));
  return vec4(throughAir(light, direction, distanceM, airLeft), 1.0) * opacity;
}
