// What the last frame saw of the cloud that a ray of this one meets, found by the cloud's mean distance.
#include "clouds/uniforms.glsl"
#include "clouds/view.glsl"

layout(binding = 9) uniform sampler2D pastLight;
layout(binding = 10) uniform sampler2D pastDistances;
layout(binding = 11) uniform sampler2D pastDepth;
layout(binding = 12) uniform sampler2D pastDoubt;

uniform mat4 toPast;    // of a place relative to the eye that the wind drives along, to clip space then
uniform vec3 eyeMoved;  // since then, against the wind (m)
uniform vec4 past;      // width, height (0: there is none), near plane then (m), exposure now over that then

// A cloud is not the same when what tells where it was is off by so many pixels between its nearest and farthest part.
const float kMostParallax = 1.0;
// Surfaces differ when their distances do by more than this share.
const float kSameSurface = 0.05;

// A frame in which the eye moves by a share of the cloud's distance adds so much of it to the doubt: clouds near by change
// as one flies through them.
const float kDoubtOfMotion = 4.0;

struct Past {
  vec4 seen;
  float distanceM;  // from the eye now
  float doubt;      // by how much it may be off, squared: grows with each frame in which the ray is not marched
  bool isKnown;
};

Past unknownPast() { return Past(vec4(0.0, 0.0, 0.0, 1.0), kFarDistance, 0.0, false); }

// In texels, 0 in the middle of the first; w: along the view axis, m.
vec3 pastPlace(vec3 place) {
  vec4 clip = toPast * vec4(place, 1.0);
  return vec3((clip.xy / clip.w * 0.5 + 0.5) * past.xy - 0.5, clip.w);
}

ivec2 pastTexel(ivec2 at) { return clamp(at, ivec2(0), textureSize(pastLight, 0) - 1); }

// Distance times opacity, and opacity.
vec2 pastDistance(ivec2 at) {
  ivec2 texel = pastTexel(at);
  float opacity = 1.0 - texelFetch(pastLight, texel, 0).w;
  return vec2(texelFetch(pastDistances, texel, 0).x * opacity, opacity);
}

// About how far away cloud is around a pixel, by the last frame alone.
float distanceAroundPast(ivec2 pixel) {
  vec3 direction = normalize(rayThrough(vec2(pixel) + 0.5));
  ivec2 at = ivec2(round(pastPlace(direction * kFarDistance).xy));
  vec2 sum = pastDistance(at);
  for (int i = 0; i < 4; ++i) sum += pastDistance(at + 4 * ivec2((i & 1) * 2 - 1, (i & 2) - 1));
  return sum.y > 0.01 ? sum.x / sum.y : kFarDistance;
}

// The same from the four texels around a place.
float distanceThere(vec2 at, float otherwise) {
  ivec2 corner = ivec2(floor(at));
  vec2 sum = pastDistance(corner) + pastDistance(corner + ivec2(1, 0)) + pastDistance(corner + ivec2(0, 1)) +
             pastDistance(corner + ivec2(1, 1));
  return sum.y > 0.01 ? sum.x / sum.y : otherwise;
}

// Of Catmull and Rom's cubic, for a place between the second and the third of four texels.
vec4 cubicWeights(float t) {
  float t2 = t * t;
  float t3 = t2 * t;
  return 0.5 * vec4(2.0 * t2 - t3 - t, 3.0 * t3 - 5.0 * t2 + 2.0, t + 4.0 * t2 - 3.0 * t3, t3 - t2);
}

// Close to a texel's middle it is that texel: a picture at rest stays as it is.
float snapped(float t) { return abs(t - round(t)) < 1.0 / 512.0 ? round(t) : t; }

bool isFinite(vec4 seen, float distanceM) {
  return all(lessThanEqual(abs(seen.xyz), vec3(kBrightest))) && seen.w >= 0.0 && seen.w <= 1.0 && distanceM > 0.0 &&
         distanceM <= 65504.0;
}

Past pastOf(ivec2 pixel, float guessM, float cloudEndM) {
  vec3 ray = rayThrough(vec2(pixel) + 0.5);
  vec3 direction = normalize(ray);
  float surfaceM = min(sceneDistance(depthAt(pixel), ray), 1e6);
  float distanceM = guessM;
  vec3 place = pastPlace(direction * distanceM);
  for (int i = 0; i < 2; ++i) {
    // What was so far from the eye then is that much farther now.
    float then = length(direction * distanceM + eyeMoved);
    distanceM = max(distanceThere(place.xy, then) - then + distanceM, 1.0);
    place = pastPlace(direction * distanceM);
  }
  vec2 at = vec2(snapped(place.x), snapped(place.y));
  ivec2 corner = ivec2(floor(at));
  vec4 across = cubicWeights(at.x - floor(at.x));
  vec4 up = cubicWeights(at.y - floor(at.y));
  vec3 end = direction * distanceM + eyeMoved;
  float axisToRay = length(end) / place.z;
  float surfaceThen = length(direction * surfaceM + eyeMoved);
  bool isBehind = surfaceM >= cloudEndM;
  vec4 seen = vec4(0.0);
  vec2 meanDistance = vec2(0.0);
  float nearest = kFarDistance;
  float farthest = 0.0;
  vec2 within = at - floor(at);
  float between = max(within.x * (1.0 - within.x), within.y * (1.0 - within.y));
  vec4 least = vec4(kBrightest);
  vec4 most = vec4(0.0);
  float doubt = 0.0;
  bool isKnown = past.x > 0.0 && all(greaterThanEqual(at, vec2(-0.5))) && all(lessThanEqual(at, past.xy - 0.5)) && place.z > 0.0;
  for (int i = 0; i < 16; ++i) {
    ivec2 tap = ivec2(i & 3, i >> 2);
    float weight = across[tap.x] * up[tap.y];
    ivec2 texel = pastTexel(corner + tap - 1);
    vec4 light = texelFetch(pastLight, texel, 0);
    float distance = texelFetch(pastDistances, texel, 0).x;
    float depth = texelFetch(pastDepth, texel, 0).x;
    float surface = depth > 0.0 ? min(past.z / depth * axisToRay, 1e6) : 1e6;
    bool isSame = (isBehind && surface >= cloudEndM) || abs(surface - surfaceThen) <= kSameSurface * surfaceThen;
    isKnown = isKnown && (weight == 0.0 || (isFinite(light, distance) && isSame));
    seen += weight != 0.0 ? weight * light : vec4(0.0);
    doubt += max(weight, 0.0) * texelFetch(pastDoubt, texel, 0).x;
    bool isInner = max(abs(float(tap.x) - 1.5), abs(float(tap.y) - 1.5)) < 1.0;
    least = isInner ? min(least, light) : least;
    most = isInner ? max(most, light) : most;
    float opacity = 1.0 - light.w;
    bool counts = weight != 0.0 && opacity > 0.05;
    nearest = counts ? min(nearest, distance) : nearest;
    farthest = counts ? max(farthest, distance) : farthest;
    meanDistance += max(weight, 0.0) * opacity * vec2(distance, 1.0);
  }
  vec4 range = most - least;
  float contrast = max(max(range.x, range.y), max(range.z, range.w));
  doubt += contrast * contrast * between + kDoubtOfMotion * length(eyeMoved) / distanceM;
  vec2 apart = pastPlace(direction * nearest).xy - pastPlace(direction * farthest).xy;
  isKnown = isKnown && (farthest <= nearest || dot(apart, apart) <= kMostParallax * kMostParallax);
  float then = length(end);
  float mean = meanDistance.y > 0.0 ? meanDistance.x / meanDistance.y - then + distanceM : kFarDistance;
  return Past(vec4(max(seen.xyz * past.w, vec3(0.0)), clamp(seen.w, 0.0, 1.0)), clamp(mean, 1.0, kFarDistance), doubt,
              isKnown);
}
