// Goes along a ray through the layer, from span to span of the tile's.
// The density before erosion, unclamped, tells about how far away cloud is (cloudShapeEstimate): clear air is crossed by
// whole steps as far as that is safe. So every sample is one of cloud or of the air beside it, rays that run together do
// the same, and there is no other way through. Light comes afterwards, for segments of some opacity at once: the two
// loops have samples of their own, and neither waits for the other.
#include "clouds/field.glsl"
#include "clouds/gathered.glsl"
#include "clouds/steps.glsl"
#include "clouds/tiles.glsl"
#include "shared/cloud_march.glsl"

layout(std430, binding = 1) readonly buffer Spans { vec2 spans[]; };

// Of what lies where a ray is given up, by that of the place: measured, so that no tier is brighter or darker than the
// reference in the mean.
const float kBrightnessOfRest = 0.5;

// Opacity, and distance times opacity, of what is lit at one place. 256 bytes a ray.
vec2 segments[kMostSegments];

// How far from a sample on the air is clear, about.
float clearDistance(MediumSample medium, float slope) {
  return medium.extinction > 0.0 ? 0.0 : (clouds.strides.x - medium.shape) * slope;
}

// From a distance on, whatever surface there is before: what a ray meets, in segments; their number.
int gatherSegments(vec3 direction, int spansAt, float surfaceM, out float transmittance) {
  int parts = int(spans[spansAt].x);
  int part = 0;
  int count = 0;
  transmittance = 1.0;
  vec2 open = vec2(0.0);
  float at = 0.0;
  float end = 0.0;
  float stride = 0.0;
  int iterations = kMostIterations / kSamplesATurn;
  while (transmittance > clouds.march.w && (at < end || part < parts) && iterations > 0) {
    --iterations;
    while (at >= end && part < parts) {
      ++part;
      vec2 span = spans[spansAt + part];
      // Turns of neighbouring rays are cut alike, as steps are.
      at = max(at, alignedBefore(span.x, float(kSamplesATurn)));
      end = min(span.y, surfaceM);
      stride = 0.0;
    }
    float step = stepAt(at);
    vec2 gained = vec2(0.0);
    for (int i = 0; i < kSamplesATurn; ++i) {
      float length = clamp(end - at, 0.0, step);
      float middle = at + 0.5 * length;
      MediumSample medium = sampleAt(direction * middle);
      // A stride that ends in cloud is taken back.
      bool isTooFar = stride > step && medium.extinction > 0.0;
      length = isTooFar ? 0.0 : length;
      float gain = transmittance * stepOpacity(medium.extinction * cloudFade(middle, clouds.layer.z) * length);
      gained += vec2(gain, gain * middle);
      transmittance -= gain;
      float next = step * max(1.0, floor(clearDistance(medium, clouds.strides.y) / step));
      at += isTooFar ? step - stride : next;
      stride = isTooFar ? step : next;
    }
    open += gained;
    // Where segments get scarce, those that are left have to suffice for all light that is left.
    float scarce = count < kThinSegments ? 0.0 : transmittance / float(kMostSegments - count);
    float enough = max(clouds.march.z, scarce);
    segments[count] = open;
    bool closes = open.x > enough && count < kMostSegments - 1;
    count += closes ? 1 : 0;
    open = closes ? vec2(0.0) : open;
  }
  // What is not worth following is deeper and darker than the last of what was.
  float rest = transmittance > clouds.march.w ? 0.0 : transmittance;
  open += kBrightnessOfRest * vec2(rest, rest * at);
  transmittance -= rest;
  segments[count] = open;
  return open.x > 0.0 ? count + 1 : count;
}

// The way from a segment to the sun, through the layer: the finer, the more the segment's light counts.
struct SunRay {
  vec3 place;
  float height;
  float total;  // m, to the top of the layer
  float first;  // m, step
  float at;
  float depth;
};

SunRay sunRayOf(vec2 segment, vec3 direction) {
  vec3 place = direction * (segment.y / max(segment.x, 1e-20));
  float height = heightFraction(place);
  float length = max(1.0 - height, 0.0) * clouds.layer.y / clouds.toSun.y;
  return SunRay(place, height, length, clouds.sunSteps.x * inversesqrt(max(segment.x, 0.01)), 0.0, 0.0);
}

void stepTowardsSun(inout SunRay way) {
  float step = way.first + clouds.sunSteps.y * way.at + clouds.sunSteps.z * way.depth;
  float length = clamp(way.total - way.at, 0.0, step);
  MediumSample medium = sampleAt(way.place + clouds.toSun.xyz * (way.at + 0.5 * length));
  way.depth += medium.extinction * length;
  way.at += max(step, clearDistance(medium, clouds.strides.z));
}

void addLight(inout Gathered gathered, vec2 segment, SunRay way, vec4 phases) {
  gathered.sun += segment.x * scatteredSun(phases, way.depth);
  gathered.sky += segment.x * scatteredSky(way.height);
  gathered.ground += segment.x * scatteredGround(way.height);
  gathered.weight += segment.x;
  gathered.distance += segment.y;
}

// Each ray goes on to its next segment when it is through with one: rays that run together do not wait for the longest way
// of each segment.
Gathered marchRay(vec3 direction, int spansAt, float surfaceM) {
  Gathered gathered = Gathered(0.0, 0.0, 0.0, 1.0, 0.0, 0.0);
  int count = gatherSegments(direction, spansAt, surfaceM, gathered.transmittance);
  vec4 phases = cloudPhases(dot(direction, frame.toSun.xyz), clouds.scattering.x, clouds.scattering.y);
  vec2 segment = segments[0];
  SunRay way = sunRayOf(segment, direction);
  int i = 0;
  while (i < count) {
    for (int k = 0; k < kSunSamplesATurn; ++k) stepTowardsSun(way);
    bool isThrough = way.at >= way.total;
    // A loop of one turn at most, and not a branch: a software renderer leaves it out where no ray needs it.
    while (isThrough) {
      addLight(gathered, segment, way, phases);
      ++i;
      segment = segments[min(i, kMostSegments - 1)];
      way = sunRayOf(segment, direction);
      isThrough = false;
    }
  }
  return gathered;
}
