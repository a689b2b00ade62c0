// Rings and wakes on the sea (render::WakePass): what waves of bursts make of the light of a level sea, and their foam.
#include "frame.glsl"
#include "shared/lattice_noise.glsl"
#include "shared/spray.glsl"
#include "shared/sun_glitter.glsl"
#include "shared/water.glsl"
#include "spray/seen.glsl"

const int kMostWakes = 24;          // as in render/spray/wake_pass.h
uniform vec4 wakePlaces[kMostWakes];  // x and z relative to the eye (m); seconds since; radius of the body (m)
uniform vec4 wakeLooks[kMostWakes];   // slope of the waves; radius (m) and cover of the foam; distance the waves reach (m)
uniform int wakeCount;
uniform vec4 wakeShares;   // of the light
uniform ivec2 wakeCell;    // of the foam's lattice, below the eye
uniform vec2 wakeInside;   // of the eye in it, cells

const float kFoamCellM = 0.55;
const float kFoamLight = 0.55;    // albedo (Koepke 1984)
const float kSteepest = 0.45;     // slope of the steepest waves of deep water (Michell 1893: height / length .142)
const float kSlopeHidden = 0.12;  // of the waves of the sea under it

vec3 wakePlaceOf(vec3 fragCoord) {
  vec2 ndc = fragCoord.xy * frame.viewport.zw * 2.0 - 1.0;
  vec3 ray = (frame.ndcToRay * vec4(ndc, 1.0, 0.0)).xyz;
  return ray * (frame.eye.x / max(-ray.y, 1e-7));
}

struct WakeSum {
  vec2 slope;
  float foam;
};

// Waves of all bursts at a place; those shorter than pixels show are left out.
WakeSum wakesAt(vec2 place, float footprint) {
  WakeSum sum = WakeSum(vec2(0.0), 0.0);
  for (int i = 0; i < wakeCount; ++i) {
    vec2 from = place - wakePlaces[i].xy;
    float away = length(from);
    float reach = smoothstep(1.0, 0.7, away / wakeLooks[i].w);
    float waveM = 2.0 * kPi * wakePlaces[i].w;
    float shown = smoothstep(0.5, 0.2, footprint / waveM);
    float slope = impactWaveSlope(away, wakePlaces[i].z, wakePlaces[i].w) * wakeLooks[i].x * reach * shown;
    sum.slope += from / max(away, 0.05) * slope;
    float in2 = away / wakeLooks[i].y;
    sum.foam += wakeLooks[i].z * exp(-min(in2 * in2, 20.0));
  }
  // Steeper waves break.
  sum.slope /= sqrt(1.0 + dot(sum.slope, sum.slope) / (kSteepest * kSteepest));
  return sum;
}

float foamNoise(vec2 place, float scale, uint salt) {
  vec2 at = (wakeInside + place / kFoamCellM) * scale;
  vec2 cell = floor(at);
  return latticeNoise(uvec2(wakeCell * int(scale) + ivec2(cell)) + salt, at - cell).x;
}

// Lace where there is little of it; its mean where pixels are wide.
float foamCover(float foam, vec2 place, float footprint) {
  float shown = saturate(1.5 - footprint / kFoamCellM);
  float noise = foamNoise(place, 1.0, 0u) + 0.7 * foamNoise(place, 3.0, 7u) * saturate(1.5 - 3.0 * footprint / kFoamCellM);
  float f = 1.0 - exp(-1.6 * foam);
  return mix(0.7 * f, smoothstep(0.0, 0.5, f * 1.5 - 0.55 + 0.95 * noise) * min(0.9, 2.0 * f), shown);
}

// The level sea's light towards the eye where waves tilt it.
vec3 tiltedSea(vec3 toEye, vec2 slope) {
  vec3 normal = normalize(vec3(-slope.x, 1.0, -slope.y));
  float reflectance = seaReflectance(max(dot(toEye, normal), 0.02), kSlopeHidden);
  vec3 mirrored = reflect(-toEye, normal);
  mirrored = normalize(vec3(mirrored.x, max(mirrored.y, 0.02), mirrored.z));
  vec3 sky = skyTowards(mirrored) * wakeShares.y + diffuseSunTowards(mirrored, wakeShares.xyz);
  vec3 glitter = frame.sunLight.xyz * (wakeShares.x * sunGlitter(toEye, frame.toSun.xyz, frame.toSun.w, -slope,
                                                                  kSlopeHidden, kSlopeHidden));
  vec3 body = shadeLambert(seaBodyAlbedo(), vec3(0.0, 1.0, 0.0), wakeShares.xyz);
  return sky * reflectance + glitter + body * (1.0 - reflectance);
}

struct WakeLight {
  vec3 added;
  vec3 left;  // factor on the picture
};

WakeLight wakeSeen(vec3 fragCoord) {
  vec3 place = wakePlaceOf(fragCoord);
  float distanceM = length(place);
  vec3 toEye = -place / distanceM;
  float footprint = distanceM * frame.depthToSea.w / max(toEye.y, 0.05);
  WakeSum sum = wakesAt(place.xz, footprint);
  // Not where something stands before the sea.
  float seen = saturate(1.0 - 200.0 * (viewZOfDepth(fragCoord.z, frame.eye.y) /
                                       viewZOfDepth(texelFetch(sceneDepth, ivec2(fragCoord.xy), 0).r, frame.eye.y) - 1.0 - 0.004)) *
               throughClouds(distanceM);
  float cover = foamCover(sum.foam, place.xz, footprint) * seen;
  // Where waves make it darker the picture is, with all its waves; where they make it brighter, light is added.
  vec3 level = tiltedSea(toEye, vec2(0.0)), tilted = tiltedSea(toEye, sum.slope);
  vec3 factor = clamp(tilted / max(level, vec3(1e-6)), vec3(0.2), vec3(1.0));
  WakeLight light;
  vec3 foam = kFoamLight * shadeLambert(vec3(1.0), vec3(0.0, 1.0, 0.0), wakeShares.xyz);
  vec3 brighter = max(tilted - level, vec3(0.0)) * (seen * (1.0 - cover));
  light.added = min(applyAerialPerspective(foam, place) * cover + brighter, vec3(kBrightest));
  light.left = mix(vec3(1.0), factor, seen) * (1.0 - cover);
  return light;
}
