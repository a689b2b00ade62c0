// Light and opacity of the cloud dome in a direction, multiplied together.
#include "clouds/sheet_light.glsl"

layout(binding = 0) uniform sampler3D noise;
uniform float scale;
uniform float flatness;
uniform vec3 offset;        // of the noise, copies of the volume, [0, 1)
uniform float cutoff;
uniform float bias;
uniform float noiseMean;
uniform vec3 cloudColor;

// Standard deviations of noise over which the cut is softened: of what is seen, and of the shade.
const float kDomeSoftCut = 0.03, kDomeShadeBlur = 0.06;

// The fine copy of the noise: its frequency and its share.
const float kDomeFineScale = 7.31;
const float kDomeFineShare = 0.2;

// The volume is cut at a slant to its lattice, so that the cut itself never repeats.
vec3 noisePlace(vec3 place) { return domeTurn(place) * scale + offset; }

// A second, finer copy covers the texels of the first where they are wider than pixels.
float noiseAt(vec3 place) {
  vec3 at = noisePlace(place);
  float fine = texture(noise, at * kDomeFineScale + vec3(0.37, 0.11, 0.73)).r - noiseMean;
  return texture(noise, at).r + kDomeFineShare * fine;
}

vec4 domeLight(vec3 direction, float rim, vec3 airLeft) {
  vec3 place = domePlace(direction, flatness);
  SheetCover cover = sheetCover(noiseAt(place), kDomeSoftCut, cutoff, depthPerNoise);
  float here = cover.depth;
  vec3 sunPlace = domePlace(directionOf(vec3(frame.toSun.x, max(frame.toSun.y, 0.05), frame.toSun.z), vec3(0.0, 1.0, 0.0)), flatness);
  vec3 towardsSun = directionOf(sunPlace - place, vec3(0.0, 1.0, 0.0)) * min(length(sunPlace - place), 0.12);
  float shade = meanDepth(texture(noise, noisePlace(place + towardsSun)).r - cutoff, kDomeShadeBlur);
  float distanceM = domeDistance(direction.y, frame.eye.x);
  vec3 light = sheetLight(direction, here, shade, 0.0, sheetSunShare(direction * distanceM)) * cloudColor;
  float opacity = bias * sheetCoverOpacity(cover, 1.0) * smoothstep(0.0, 1.0, rim);
  return vec4(throughAir(light, direction, distanceM, airLeft), 1.0) * opacity;
}
