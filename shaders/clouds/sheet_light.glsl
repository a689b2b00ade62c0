// Light of clouds without thickness as the eye sees it, before opacity. Light is multiplied by exposure.
#include "frame.glsl"
#include "clouds/land_shade.glsl"
#include "shared/cloud_sheet.glsl"

uniform vec3 sheetSun;       // illuminance by the sun at the sheet's height, which sees it longer than the eye does
uniform float depthPerNoise; // optical depth by noise above the cutoff
uniform float selfShadow;    // optical depth towards the sun as a multiple of the one that is seen

// Anisotropy of the bright rim around the sun, and its share of light that was scattered once; light that was scattered
// more often is nearly even: two lobes in place of the eight of cloudPhases().
const float kSheetForward = 0.78;
const float kSheetForwardShare = 0.45;

const float kLitGain = 1.35;

vec4 sheetPhases(float cosAngle) {
  float forward = henyeyGreenstein(cosAngle, kSheetForward);
  float even = (1.0 + 0.45 * cosAngle) / (4.0 * kPi);
  vec4 phases = vec4(mix(even, forward, kSheetForwardShare), mix(even, forward, 0.12), even, even);
  return phases * vec4(1.0, kOctaveLight, kOctaveLight * kOctaveLight, kOctaveLight * kOctaveLight * kOctaveLight);
}

// exp(-x) for x >= 0 within 0.06, without a transcendental function: light within a sheet is no more exact than that.
float fading(float x) { return 1.0 / (1.0 + x + 0.5 * x * x); }

// scatteredSun() of four octaves by fading().
float sheetScatteredSun(vec4 phases, float depth) {
  return phases.x * fading(depth) + phases.y * fading(kOctaveDepth * depth) +
         phases.z * fading(kOctaveDepth * kOctaveDepth * depth) +
         phases.w * fading(kOctaveDepth * kOctaveDepth * kOctaveDepth * depth);
}

// Optical depth that sunlight crosses before it turns towards the eye. lit: 1 where the eye sees the face that the sun
// shines on, 0 where it sees the other. A lit face shows what is near it, and shade where the sheet is deeper towards
// the sun; the other shows what comes through.
float sheetSunDepth(float here, float sunward, float lit) {
  float through = 0.45 * here + 0.55 * sunward;
  float shade = 0.1 * here + 0.9 * max(sunward - here, 0.0);
  return mix(through, shade, lit);
}

// What mountains leave of the sun at a place of the sheet.
#ifdef LAND_SHADE
uniform float landShade;  // share of their shade that counts
float sheetSunShare(vec3 relative) { return 1.0 - landShade * (1.0 - sunOverLand(relative)); }
#else
float sheetSunShare(vec3 relative) { return 1.0; }
#endif

// here, sunward: optical depth straight through at the place and a little way towards the sun; top: 1 where the eye sees
// the sheet from above, 0 from below; sunShare: of the sun's light that reaches the sheet there.
vec3 sheetLight(vec3 direction, float here, float sunward, float top, float sunShare) {
  // A sun that is below the horizon of the eye still lights a high sheet, from its side.
  float lit = mix(smoothstep(0.25, -0.05, frame.toSun.y) * 0.7, 1.0, top);
  float depth = selfShadow * sheetSunDepth(here, sunward, lit);
  // What is lit on the eye's side shows light that went into the sheet and came out of it again as well.
  // Slopes towards the sun, where the sheet thins, are brighter; that is all the relief that a sheet has.
  float slope = 1.0 + 0.35 * clamp(here - sunward, -1.0, 1.0) * lit;
  vec3 sun = sheetSun * (sunShare * mix(1.0, kLitGain, lit) * slope) * sheetScatteredSun(sheetPhases(dot(direction, frame.toSun.xyz)), depth);
  float high = mix(0.15, 0.9, top);
  // Bases see the sky through what is above them: less where they are thick.
  float open = mix(0.35 + 0.65 * fading(0.35 * selfShadow * here), 1.0, top);
  vec3 ambient = frame.skyLight.xyz * (scatteredSky(high) * open) + frame.groundLight.xyz * scatteredGround(high);
  return min(sun + ambient, vec3(kBrightest));
}

// Mean depth of noise that lies `above` the cutoff and spreads around it: sheetCover() times its share, as a parabola.
float meanDepth(float above, float spread) {
  float reach = 2.0 * spread;
  float inside = clamp(above + reach, 0.0, 2.0 * reach);
  return depthPerNoise * (inside * inside / (4.0 * reach) + max(above - reach, 0.0));
}

// applyAerialPerspective() with the transmittance of the air from the vertices.
vec3 throughAir(vec3 light, vec3 direction, float distanceM, vec3 airLeft) {
#ifdef HAZE
  return light * airLeft + airRadiance(direction, distanceM) * (1.0 - airLeft);
#else
  return light;
#endif
}
