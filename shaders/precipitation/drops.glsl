// Drops and flakes around the eye as streaks: where the corners of each are (src/render/precipitation/drop_sets.cpp has the
// cells), and what it covers of a pixel. Positions are relative to the eye, in world axes (metres).
#include "frame.glsl"
#include "shared/hash.glsl"

struct DropSet {  // render::DropSet
  vec4 corner;
  vec4 passing;
  vec4 look;
  vec4 light;
  uvec4 first;
  ivec4 counts;
};

layout(std140, binding = 3) uniform Drops {
  vec4 ambient;   // rgb: radiance of what surrounds a drop; w: how far away drops are drawn (m)
  vec4 sun;       // rgb: illuminance by the sun; w: shutter (s)
  DropSet sets[14];
} drops;

const float kNearestM = 0.35;   // of a streak's ends along the view axis

// A streak in the picture: a box with a soft edge of a pixel.
struct Streak {
  vec4 position;  // of the corner
  vec2 aside;     // of the corner from the middle: across and along, pixels
  vec2 extent;     // width and length, pixels, halved
  vec4 light;     // rgb; opacity
  float depth;    // reversed
};

Streak noStreak() {
  return Streak(vec4(2.0, 2.0, 0.5, 1.0), vec2(0.0), vec2(0.0), vec4(0.0), 0.0);
}

vec3 placeInCell(uvec3 bits) { return vec3(unitOf(bits.x), unitOf(bits.y), unitOf(bits.z)); }

// Of the light that a drop sends: forward, and evenly to all sides.
vec3 lightOfDrop(vec3 direction, float forward) {
  float c = dot(direction, frame.toSun.xyz);
  float phase = forward * henyeyGreenstein(c, 0.8) + (1.0 - forward) / (4.0 * kPi);
  return drops.ambient.xyz + drops.sun.xyz * phase;
}

#ifdef SPOT_LIGHT
#include "shared/lamp.glsl"

uniform vec3 spotPlace;  // as in terrain/spot.glsl
uniform vec4 spotAxis;
uniform vec3 spotLight;

// A lamp near the eye is seen by what drops send back.
vec3 lampOnDrop(vec3 place) {
  vec3 toLamp = spotPlace - place;
  vec3 towards = toLamp * inversesqrt(max(dot(toLamp, toLamp), 1e-6));
  return spotLight * (spotIlluminance(toLamp, towards, spotAxis.xyz, spotAxis.w) / (4.0 * kPi));
}
#else
vec3 lampOnDrop(vec3 place) { return vec3(0.0); }
#endif

// Flakes sway: where (xyz), and how fast.
vec3 swayOf(uvec3 bits, float flutterM, float seconds, out vec3 velocity) {
  vec2 rate = 2.0 + 3.0 * vec2(unitOf(bits.y * 0x9e3779b1u), unitOf(bits.z * 0x85ebca77u));  // 1/s
  vec2 phase = rate * seconds + 6.2831853 * vec2(unitOf(bits.z * 0x9e3779b1u), unitOf(bits.x * 0x85ebca77u));
  velocity = flutterM * vec3(rate.x * cos(phase.x), 0.0, rate.y * cos(phase.y));
  return flutterM * vec3(sin(phase.x), 0.0, sin(phase.y));
}

// One of the four corners (vertex & 3) of a set's drop (vertex >> 2).
Streak streakCorner(int vertex, int setIndex) {
  DropSet set = drops.sets[setIndex];
  int drop = vertex >> 2;
  if (drop >= set.counts.w) return noStreak();
  ivec3 cell = ivec3(drop % set.counts.x, drop / set.counts.x % set.counts.y, drop / (set.counts.x * set.counts.y));
  uvec3 bits = hash3(set.first.xyz + uvec3(cell) + uvec3(set.first.w, set.first.w >> 7u, set.first.w * 0x9e3779b1u));
  if (unitOf(bits.x * 0xc2b2ae35u + bits.y) >= set.passing.w) return noStreak();
  vec3 swaying;
  vec3 middle = set.corner.xyz + (vec3(cell) + placeInCell(bits)) * set.corner.w +
                swayOf(bits, set.look.w, set.light.y, swaying);
  vec3 passed = (set.passing.xyz + swaying) * (0.5 * drops.sun.w);

  float distanceM = length(middle);
  vec4 from = frame.viewProjection * vec4(middle - passed, 1.0);
  vec4 to = frame.viewProjection * vec4(middle + passed, 1.0);
  if (distanceM >= drops.ambient.w || max(from.w, to.w) <= kNearestM) return noStreak();
  // What lies behind the eye is cut off, along the streak.
  vec4 span = to - from;
  if (from.w < kNearestM) from += span * ((kNearestM - from.w) / span.w);
  if (to.w < kNearestM) to += span * ((kNearestM - to.w) / span.w);

  vec2 halfPicture = 0.5 * frame.viewport.xy;
  vec2 a = from.xy / from.w * halfPicture, b = to.xy / to.w * halfPicture;
  vec2 along = b - a;
  float lengthPixels = length(along);
  along = lengthPixels > 1e-3 ? along / lengthPixels : vec2(0.0, 1.0);
  float pixelM = distanceM * frame.depthToSea.w;
  float widthPixels = max(set.look.x / pixelM, set.light.z);  // thinner ones are fainter
  float allPixels = lengthPixels + widthPixels;
  // As opaque as what it stands for, spread over the streak.
  float opacity = min(set.look.y / (pixelM * pixelM * widthPixels * allPixels), set.look.z);
  opacity *= smoothstep(1.0, 0.6, distanceM / drops.ambient.w) * smoothstep(0.5, 1.2, distanceM);

  vec2 corner = vec2((vertex & 1) != 0 ? 1.0 : -1.0, (vertex & 2) != 0 ? 1.0 : -1.0);
  Streak streak;
  streak.extent = 0.5 * vec2(widthPixels, allPixels);
  streak.aside = corner * (streak.extent + 0.5);
  vec2 at = 0.5 * (a + b) + along * streak.aside.y + vec2(along.y, -along.x) * streak.aside.x;
  float viewZ = corner.y > 0.0 ? to.w : from.w;
  streak.depth = depthOfViewZ(viewZ, frame.eye.y);
  streak.position = vec4(at / halfPicture, 0.5, 1.0);
  vec3 light = lightOfDrop(middle / max(distanceM, 1e-3), set.light.x) + lampOnDrop(middle);
  streak.light = vec4(min(light, vec3(kBrightest)), opacity);
  return streak;
}

// Share of a pixel that a streak covers, at a place in it.
float coverOf(vec2 aside, vec2 extent) {
  vec2 inside = clamp(extent + 0.5 - abs(aside), 0.0, 1.0);
  return inside.x * inside.y;
}
