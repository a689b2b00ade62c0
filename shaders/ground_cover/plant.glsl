// Blades, stalks and heads of a plant: each has its place, lean and hue by the hash of plant and number.
#include "frame.glsl"
#include "shared/hash.glsl"
#include "shared/ground_cover.glsl"
#include "ground_cover/attributes.glsl"

// A vertex of a plant's mesh: number of the blade; share of its length; side, -1 to 1; part. Of a head: number; where in it
// across and along, each -1 to 1.
layout(location = 0) in vec4 plantVertex;

const float kHeadPart = 1.0;   // of a flower or a reed
const float kStalkPart = 2.0;  // that bears one
const float kFirstRareBlade = 8.0;   // from this number on blades of a tuft are seen close by alone; as in cover_meshes.cpp

struct PlantVertex {
  vec3 relative;
  vec3 light;
};

struct Blade {
  vec3 root;    // relative to the foot, m
  vec3 lean;    // how far its tip is from being upright, m
  float heightM;
  float wideM;  // half, at the root
  float straw;  // [0, 1]
  float tint;   // [0, 1)
};

Blade bladeOf(float number, float kind) {
  uvec2 bits = hash2(uvec2(uint(coverForm.w), uint(number) + 131u));
  float a = float(bits.x & 0xffffu) / 65536.0, b = float(bits.x >> 16) / 65536.0;
  float c = float(bits.y & 0xffffu) / 65536.0, d = float(bits.y >> 16) / 65536.0;
  float angle = coverForm.y + 2.0 * kPi * a;
  vec2 aside = vec2(cos(angle), sin(angle));
  float outwards = sqrt(b);
  Blade blade;
  blade.heightM = coverFoot.w * mix(0.55, 1.0, c);
  vec2 at = aside * (coverForm.x * (kind == float(kTuft) ? 0.75 : 0.95) * outwards);
  blade.root = vec3(at.x, -dot(at, coverNormal.xz) / max(coverNormal.y, 0.3), at.y);
  float bowed = kind == float(kTuft) ? 0.25 + 0.65 * outwards : 0.08 + 0.22 * d;
  vec2 turned = normalize(aside + 0.9 * vec2(d - 0.5, fract(7.0 * d) - 0.5));
  blade.lean = vec3(turned.x, 0.0, turned.y) * (bowed * blade.heightM);
  blade.wideM = (kind == float(kReeds) ? 0.016 : min(0.035 * coverForm.x + 0.004, 0.009 + 0.0016 * coverAir.w)) * mix(0.7, 1.2, d);
  blade.straw = saturate(coverSun.w * 1.5 - 0.55 + 0.7 * (fract(13.0 * c) - 0.5));
  blade.tint = fract(5.0 * a + 3.0 * d);
  return blade;
}

// Of the blade's middle line at a share t of its length.
vec3 bladeAt(Blade blade, float t) {
  float tremble = coverBend.z * sin(coverBend.w + 9.0 * blade.tint);
  vec3 blown = vec3(coverBend.x + tremble * 0.6, 0.0, coverBend.y + tremble);
  vec3 bow = (blade.lean + blown) * (t * t);
  float sunk = dot(bow, bow) / max(2.0 * blade.heightM, 1e-4);  // a blade that is bowed is no longer
  return coverFoot.xyz + blade.root + bow + vec3(0.0, max(blade.heightM * t - sunk, -0.05), 0.0);
}

float pixelM(float distanceM) { return distanceM * frame.depthToSea.w; }

vec3 acrossView(vec3 along, vec3 relative) {
  vec3 across = cross(along, relative);
  float l = length(across);
  return l > 1e-5 ? across / l : vec3(1.0, 0.0, 0.0);
}

// The colour of grass: that of the ground, darker at the root, lighter towards the tip, some blades straw.
vec3 bladeAlbedo(Blade blade, float t) {
  vec3 green = coverAlbedo.rgb * mix(vec3(0.68, 0.92, 0.62), vec3(1.22, 1.14, 0.95), 0.3 * blade.tint + 0.7 * coverAbove.w);
  float bright = dot(coverAlbedo.rgb, vec3(0.33));
  vec3 straw = bright * vec3(1.95, 1.55, 0.85);
  return mix(green, straw, blade.straw * (0.35 + 0.65 * t)) * mix(0.40, 1.6, t);
}

vec3 petalAlbedo(float patchColor, float own) {
  float n = fract(patchColor + 0.12 * own) * 4.0;
  return n < 1.0   ? vec3(0.62, 0.60, 0.52)    // ox-eye
         : n < 2.0 ? vec3(0.58, 0.40, 0.035)   // buttercup
         : n < 3.0 ? vec3(0.25, 0.13, 0.42)    // bellflower, scabious
                   : vec3(0.46, 0.085, 0.13);  // clover, campion
}

vec3 litPlant(vec3 albedo, float glow) {
  vec3 light = coverIrradiance(coverNormal.xyz) + coverSun.xyz * glow;
  return albedo * light + coverAir.xyz;
}

PlantVertex bladeVertex(float kind, bool isStalk) {
  float number = plantVertex.x, t = plantVertex.y;
  Blade blade = bladeOf(number, kind);
  float shown = number < kFirstRareBlade || kind != float(kTuft) ? 1.0 : coverNormal.w;
  blade.heightM *= mix(0.4, 1.0, shown);
  vec3 at = bladeAt(blade, t), along = bladeAt(blade, min(t + 0.3, 1.3)) - at;
  float few = kind == float(kTuft) ? 1.0 - coverNormal.w : 0.0;
  // Where blades end to be fine they are straight, as those of few corners, and the few that are left are wider.
  at = mix(at, mix(bladeAt(blade, 0.0), bladeAt(blade, 1.0), t), few);
  float wide = isStalk ? 0.004 + 0.004 * coverFoot.w : blade.wideM * (1.0 - 0.35 * t) * (1.0 + 0.4 * few);
  float seen = (isStalk ? 0.35 : 0.65) * pixelM(coverAir.w) * smoothstep(0.0, 0.4, coverBelow.w);
  wide = max(wide, seen) * (t >= 1.0 ? 0.0 : 1.0) * shown;
  PlantVertex result;
  result.relative = at + acrossView(along, at) * (wide * plantVertex.z);
  // Against the sun tips let light through.
  float against = saturate(dot(normalize(at), frame.toSun.xyz));
  vec3 albedo = kind == float(kReeds) ? mix(vec3(0.058, 0.092, 0.026), vec3(0.19, 0.165, 0.072), saturate(0.8 * blade.straw - 0.1 + 0.25 * t)) *
                                            mix(0.6, 1.35, t)
                                      : bladeAlbedo(blade, t);
  result.light = litPlant(albedo, 0.30 * t * against * against);
  return result;
}

PlantVertex headVertex(float kind) {
  Blade blade = bladeOf(plantVertex.x, kind);
  bool isReed = kind == float(kReeds);
  vec3 top = bladeAt(blade, isReed ? 0.93 : 1.0), along = normalize(top - bladeAt(blade, 0.7));
  vec3 across = acrossView(along, top), towards = -normalize(top);
  // A flower lies open to the sky, half turned to who looks at it; a reed's head is part of its stalk.
  vec3 up = isReed ? along : normalize(cross(normalize(mix(vec3(0.0, 1.0, 0.0), towards, 0.6)), across));
  float grown = smoothstep(0.0, 0.4, coverBelow.w);
  float wide = isReed ? 0.022 : mix(0.020, 0.042, blade.tint);
  float thin = wide;
  wide = max(wide, 0.75 * pixelM(coverAir.w));
  float share = thin / wide;  // of what is drawn; the rest is what stands around it
  wide *= grown;
  float tall = isReed ? max(0.11, wide) * grown : wide;
  PlantVertex result;
  result.relative = top + across * (wide * plantVertex.y) + up * (tall * plantVertex.z);
  float middle = 1.0 - max(abs(plantVertex.y), abs(plantVertex.z));
  vec3 petal = petalAlbedo(coverAlbedo.w, fract(blade.tint * 3.0 + coverAbove.w));
  vec3 albedo = isReed ? vec3(0.085, 0.046, 0.022) * mix(0.8, 1.3, blade.tint)
                       : mix(coverAlbedo.rgb, mix(petal, vec3(0.42, 0.27, 0.03), 0.8 * middle), share);
  result.light = litPlant(albedo, 0.0);
  return result;
}

// Of a tuft, which has blades alone.
PlantVertex tuftVertexAt() { return bladeVertex(float(kTuft), false); }

PlantVertex plantVertexAt() {
  float kind = coverForm.z;
  PlantVertex blade = bladeVertex(kind, plantVertex.w == kStalkPart);
  PlantVertex head = headVertex(kind);
  bool isHead = plantVertex.w == kHeadPart;
  return PlantVertex(isHead ? head.relative : blade.relative, isHead ? head.light : blade.light);
}
