// Goes along a ray through the layer, from span to span of the tile's.
// The density before erosion, unclamped, tells about how far away cloud is (cloudShapeEstimate): clear air is crossed by
// whole steps as far as that is safe. So every sample is one of cloud or of the air beside it, rays that run together do
// the same, and there is no other way through. Light comes afterwards, for segments of some opacity at once: the two
// loops have samples of their own, and neither waits for the other.
#include "clouds/field.glsl"
#include "clouds/gathered.glsl"
#include "clouds/land_shade.glsl"
#include "clouds/steps.glsl"
#include "clouds/tiles.glsl"
#include "clouds/volume_light.glsl"
#include "shared/cloud_march.glsl"

layout(std430, binding = 1) readonly buffer Spans { vec2 spans[]; };

// Of what lies where a ray is given up, by that of the place: measured, so that no tier is brighter or darker than the
// reference in the mean.
const float kBrightnessOfRest = 0.5;

// Opacity, and distance times opacity, of what is lit at one place. 256 bytes a ray.
vec2 segments[kMostSegments];

// How far from a sample on the air is clear, about. LAYERS: samples know it.
#ifdef LAYERS
float clearDistance(MediumSample medium, float slope) { return medium.clear; }
#else
float clearDistance(MediumSample medium, float slope) {
  return medium.extinction > 0.0 ? 0.0 : (clouds.strides.x - medium.shape) * slope;
}
#endif

// A ray on its way through the tile's spans.
struct Walk {
  int part;   // span that it is in, from 1
  float at;   // m from the eye
  float end;  // of the span
  float stride;
  float transmittance;
  vec2 open;  // segment that is not closed yet
  int count;  // of those that are
};

// The open segment is kept, and another begun, where it closes.
void keepSegment(inout Walk walk, bool closes) {
#ifdef FLAT_LOOPS
  segments[walk.count] = walk.open;
  walk.count += closes ? 1 : 0;
  walk.open = closes ? vec2(0.0) : walk.open;
#else
  if (!closes) return;
  segments[walk.count] = walk.open;
  ++walk.count;
  walk.open = vec2(0.0);
#endif
}

// On through the parts of the spans before a distance. isFar: those of the far field, in longer steps.
void gather(inout Walk walk, vec4 ray, int spansAt, float limitM, const bool isFar) {
  int parts = int(spans[spansAt].x);
  float longer = isFar ? clouds.farField.y : 1.0;
  int iterations = kMostIterations / kSamplesATurn;
  while (walk.transmittance > clouds.march.w && (walk.at < walk.end || (walk.part < parts && walk.at < limitM)) &&
         iterations > 0) {
    --iterations;
    while (walk.at >= walk.end && walk.part < parts && walk.at < limitM) {
      ++walk.part;
      vec2 span = spans[spansAt + walk.part];
      // Turns of neighbouring rays are cut alike, as steps are.
      walk.at = max(walk.at, alignedBefore(span.x, float(kSamplesATurn) * longer));
      walk.end = min(span.y, limitM);
      walk.stride = 0.0;
    }
    float step = stepAt(walk.at) * longer;
    vec2 gained = vec2(0.0);
    for (int i = 0; i < kSamplesATurn; ++i) {
      float length = clamp(walk.end - walk.at, 0.0, step);
      float middle = walk.at + 0.5 * length;
      vec3 place = placeOnBentRay(ray.xyz, ray.w, middle);
#ifdef LAYERS
      float rise = ray.y + 2.0 * ray.w * middle;
      MediumSample medium = isFar ? farSampleAt(place, rise) : sampleAt(place, detailLeft(middle), rise);
#else
      MediumSample medium = isFar ? farSampleAt(place) : sampleAt(place, detailLeft(middle));
#endif
      // A stride that ends in cloud is taken back.
      bool isTooFar = walk.stride > step && medium.extinction > 0.0;
      length = isTooFar ? 0.0 : length;
      float gain = walk.transmittance * stepOpacity(medium.extinction * cloudFade(middle, clouds.layer.z) * length);
      gained += vec2(gain, gain * middle);
      walk.transmittance -= gain;
      float next = step * max(1.0, floor(clearDistance(medium, clouds.strides.y) / step));
      walk.at += isTooFar ? step - walk.stride : next;
      walk.stride = isTooFar ? step : next;
    }
    walk.open += gained;
    // Where segments get scarce, those that are left have to suffice for all light that is left.
    float scarce = walk.count < kThinSegments ? 0.0 : walk.transmittance / float(kMostSegments - walk.count);
    float enough = max(clouds.march.z, scarce);
    bool closes = walk.open.x > enough && walk.count < kMostSegments - 1;
    keepSegment(walk, closes);
  }
}

// What a ray meets before a surface, in segments; their number.
int gatherSegments(vec4 ray, int spansAt, float surfaceM, out float transmittance) {
  float farBegin = clouds.farField.x;
  Walk walk = Walk(0, 0.0, 0.0, 0.0, 1.0, vec2(0.0), 0);
  gather(walk, ray, spansAt, min(surfaceM, farBegin), false);
  // The far field begins where the near one ends, not where a stride through clear air did; the span that it begins in is
  // entered again.
  walk.part = max(walk.part - 1, 0);
  walk.at = walk.transmittance > clouds.march.w ? max(farBegin, alignedBefore(walk.at, clouds.farField.y)) : walk.at;
  walk.end = 0.0;
  walk.stride = 0.0;
  gather(walk, ray, spansAt, surfaceM, true);
  // What is not worth following is deeper and darker than the last of what was.
  transmittance = walk.transmittance;
  float rest = transmittance > clouds.march.w ? 0.0 : transmittance;
  walk.open += kBrightnessOfRest * vec2(rest, rest * walk.at);
  transmittance -= rest;
  segments[walk.count] = walk.open;
  return walk.open.x > 0.0 ? walk.count + 1 : walk.count;
}

// The way from a segment to the sun, through all layers: the finer, the more the segment's light counts.
struct SunRay {
  vec3 place;
  float height;
  float total;  // m, to the top of the highest layer
  float first;  // m, step
  float detail;  // detailLeft()
  float at;
  float depth;
#ifdef LIGHT_VOLUME
  float extinction;  // of the first sample, which is as good as that of the place
#ifdef LAYERS
  float top;    // of the place's own layer
  float above;  // depth above that
#endif
#endif
};

SunRay sunRayOf(vec2 segment, vec4 ray) {
  float distanceM = segment.y / max(segment.x, 1e-20);
  vec3 place = placeOnBentRay(ray.xyz, ray.w, distanceM);
#ifdef LAYERS
  float height = 0.0;
  float length = max(clouds.shells.x - place.y, 0.0) / clouds.toSun.y;
#else
  float height = heightFraction(place);
  float length = max(1.0 - height, 0.0) * clouds.layer.y / clouds.toSun.y;
#endif
  float detail = detailLeft(distanceM);
  float first = clouds.sunSteps.x * mix(clouds.farField.y, 1.0, detail) * inversesqrt(max(segment.x, 0.01));
#if defined(LAYERS) && defined(LIGHT_VOLUME)
  return SunRay(place, height, length, first, detail, 0.0, 0.0, 0.0, topOfOwnShell(place), 0.0);
#elif defined(LIGHT_VOLUME)
  return SunRay(place, height, length, first, detail, 0.0, 0.0, 0.0);
#else
  return SunRay(place, height, length, first, detail, 0.0, 0.0);
#endif
}

void stepTowardsSun(inout SunRay way) {
  float step = way.first + clouds.sunSteps.y * way.at + clouds.sunSteps.z * way.depth;
  float length = clamp(way.total - way.at, 0.0, step);
  vec3 place = way.place + clouds.toSun.xyz * (way.at + 0.5 * length);
#ifdef LAYERS
  MediumSample medium = sampleToSun(place, way.detail);
#else
  MediumSample medium = sampleAt(place, way.detail);
#endif
  way.depth += medium.extinction * length;
#ifdef LIGHT_VOLUME
  way.extinction = way.at > 0.0 ? way.extinction : medium.extinction;
#endif
#if defined(LAYERS) && defined(LIGHT_VOLUME)
  way.above += place.y > way.top ? medium.extinction * length : 0.0;
#endif
  way.at += max(step, clearDistance(medium, clouds.strides.z));
}

void addLight(inout Gathered gathered, vec2 segment, SunRay way, vec4 phases) {
#if defined(LAYERS) && defined(LIGHT_VOLUME)
  gathered.light += segment.x * scatteredLightAt(way.place, phases, way.depth, way.above, way.extinction);
#elif defined(LAYERS)
  gathered.light += segment.x * scatteredLightAt(way.place, phases, way.depth);
#else
#ifdef LIGHT_VOLUME
  vec3 light = scatteredLightAt(way.place, way.height, phases, way.depth, way.extinction);
#else
  vec3 light = scatteredLightAt(way.height, phases, way.depth);
#endif
  gathered.sun += segment.x * light.x * sunOverLand(way.place);
  gathered.sky += segment.x * light.y;
  gathered.ground += segment.x * light.z;
#endif
  gathered.weight += segment.x;
  gathered.distance += segment.y;
}

// The light of all segments. The sums are the same in both forms, bit for bit (docs/clouds.md#on-a-graphics-card).
#ifdef FLAT_LOOPS
// For a renderer that runs rays together and leaves a part of a loop out only where none of them needs it. Each ray goes on to
// its next segment when it is through with one, so none waits for the longest way of each; the way to the next is a loop of
// one turn at most, because that is left out and a branch is not.
void lightSegments(inout Gathered gathered, int count, vec4 ray, vec4 phases) {
  vec2 segment = segments[0];
  SunRay way = sunRayOf(segment, ray);
  int i = 0;
  while (i < count) {
    for (int k = 0; k < kSunSamplesATurn; ++k) stepTowardsSun(way);
    bool isThrough = way.at >= way.total;
    while (isThrough) {
      addLight(gathered, segment, way, phases);
      ++i;
      segment = segments[min(i, kMostSegments - 1)];
      way = sunRayOf(segment, ray);
      isThrough = false;
    }
  }
}
#else
// For a graphics card.
void lightSegments(inout Gathered gathered, int count, vec4 ray, vec4 phases) {
  for (int i = 0; i < count; ++i) {
    SunRay way = sunRayOf(segments[i], ray);
    do {
      for (int k = 0; k < kSunSamplesATurn; ++k) stepTowardsSun(way);
    } while (way.at < way.total);
    addLight(gathered, segments[i], way, phases);
  }
}
#endif

Gathered marchRay(vec3 direction, int spansAt, float surfaceM) {
  Gathered gathered = nothingGathered();
  vec4 ray = vec4(direction, rayBend(direction));
  int count = gatherSegments(ray, spansAt, surfaceM, gathered.transmittance);
  lightSegments(gathered, count, ray, phasesOf(direction));
  return gathered;
}
