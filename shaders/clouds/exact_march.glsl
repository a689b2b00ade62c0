// Goes along a ray through the layer as the reference does: step by step wherever there may be cloud. Light is worked out
// once for a segment of some optical depth, at the place where the segment's opacity has its middle.
#include "clouds/gathered.glsl"
#include "clouds/land_shade.glsl"
#include "clouds/occupancy.glsl"
#include "clouds/steps.glsl"
#include "clouds/sun_depth.glsl"
#include "clouds/tiles.glsl"
#include "clouds/volume_light.glsl"
#include "shared/cloud_march.glsl"

struct March {
  Gathered gathered;
  float at;     // m from the eye
  float clear;  // 1: the last step met no cloud, and the next is judged by its end
};

March marchFrom(float begin) { return March(nothingGathered(), alignedBefore(begin, 1.0), 1.0); }

bool isUnderWay(March march, RaySpan span) { return march.at < span.end && march.gathered.transmittance > clouds.march.w; }

// A segment whose light is worked out at one place.
struct LightSegment {
  float opacity;  // of what comes from it, as the eye sees it
  float moment;   // opacity times distance
};

#ifdef LAYERS
// Of the exact march at a place: whether there is cloud before erosion, and extinction.
struct ExactSample {
  float shape;
  float extinction;
};

void addExactly(const int i, inout ExactSample medium, vec3 place) {
  float height = heightIn(clouds.layers[i], place);
  if (isInShell(height)) {
    float shape = shapeIn(clouds.layers[i], place, height);
    medium.shape = max(medium.shape, shape);
    medium.extinction += extinctionIn(clouds.layers[i], place, height, shape, 1.0);
  }
}

ExactSample exactSampleAt(vec3 place) {
  ExactSample medium = ExactSample(0.0, 0.0);
#define ADD(i) addExactly(i, medium, place);
  EACH_LAYER(ADD)
#undef ADD
  return medium;
}

// A ray in the cells of each layer.
struct CellRays {
  CellRay rays[LAYERS];
};

CellRays cellRays(vec3 direction) {
  CellRays all;
#define RAY(i) all.rays[i] = cellRayIn(i, direction);
  EACH_LAYER(RAY)
#undef RAY
  return all;
}

float leapIn(const int i, CellRay ray, float at, float rise) {
  vec3 cell = cellOnRay(ray, at);
  float height = cell.y / float(kCells.y);
  float cells = emptyCellsIn(i, ivec3(floor(cell)));
  float within = cells < 1.0 ? 0.0 : leapOnRay(ray, at, cell, cells, vec3(0.0), vec3(0.0));
  return isInShell(height) ? within : wayToShell(clouds.layers[i], height, rise);
}

float leapOfAll(CellRays all, vec3 direction, float at) {
  float rise = direction.y + 2.0 * rayBend(direction) * at;
  float way = 1e9;
#define LEAP(i) way = min(way, leapIn(i, all.rays[i], at, rise));
  EACH_LAYER(LEAP)
#undef LEAP
  return way;
}
#define CELL_RAY CellRays
#else
#define CELL_RAY CellRay
#endif

// On to where a segment is worth its light: by depth, by length, or because the ray ends.
LightSegment gatherLightSegment(inout March march, CELL_RAY ray, vec3 direction, RaySpan span, inout int iterations) {
  LightSegment segment = LightSegment(0.0, 0.0);
  float depth = 0.0;
  float begin = span.end;
  while (march.at < span.end && depth < clouds.exact.x && iterations > 0) {
    --iterations;
    float step = stepAt(march.at);
#ifdef LAYERS
    float way = leapOfAll(ray, direction, march.at);
#else
    vec3 cell = cellOnRay(ray, march.at);
    float cells = emptyCells(ivec3(floor(cell)));
    float way = cells < 1.0 ? 0.0 : leapOnRay(ray, march.at, cell, cells, vec3(0.0), vec3(0.0));
#endif
    if (way > 2.0 * step) {
      march.at = alignedBefore(march.at + way, 1.0);
      march.clear = 1.0;
      continue;
    }
    float length = min(step, span.end - march.at);
    float middle = march.at + length * mix(0.5, 1.0, march.clear);
    vec3 place = placeOnBentRay(direction, rayBend(direction), middle);
#ifdef LAYERS
    ExactSample medium = exactSampleAt(place);
    float shape = medium.shape;
    float extinction = medium.extinction;
#else
    float height = heightFraction(place);
    float shape = shapeDensity(place, height);
    float extinction = erodedDensity(place, height, shape) * clouds.layer.w;
#endif
    if (shape > 0.0 && march.clear > 0.0) {
      march.clear = 0.0;
      continue;
    }
    float stepOpticalDepth = extinction * cloudFade(middle, clouds.layer.z) * length;
    float gain = march.gathered.transmittance * stepOpacity(stepOpticalDepth);
    begin = gain > 0.0 ? min(begin, march.at) : begin;
    segment.opacity += gain;
    segment.moment += gain * middle;
    march.gathered.transmittance -= gain;
    depth += stepOpticalDepth;
    march.clear = shape > 0.0 ? 0.0 : 1.0;
    march.at += step;
    if (march.at - begin > float(kMaxStepsPerSegment) * step) break;
  }
  return segment;
}

void marchOn(inout March march, vec3 direction, RaySpan span) {
#ifdef LAYERS
  CellRays ray = cellRays(direction);
#else
  CellRay ray = cellRay(direction);
#endif
  vec4 phases = phasesOf(direction);
  int iterations = kMostIterations;
  while (isUnderWay(march, span) && iterations > 0) {
    LightSegment segment = gatherLightSegment(march, ray, direction, span, iterations);
    if (segment.opacity <= 0.0) break;
    iterations -= sunSamples;
    vec3 place = placeOnBentRay(direction, rayBend(direction), segment.moment / segment.opacity);
#ifdef LAYERS
    iterations -= sunSamples * (LAYERS - 1);
#ifdef LIGHT_VOLUME
    march.gathered.light += segment.opacity * scatteredLightAt(place, phases, sunDepth(place), sunDepthOfOthers(place),
                                                               exactSampleAt(place).extinction);
#else
    march.gathered.light += segment.opacity * scatteredLightAt(place, phases, sunDepth(place));
#endif
#else
    float height = heightFraction(place);
    float depthToSun = sunDepth(place, height);
#ifdef LIGHT_VOLUME
    vec3 light = scatteredLightAt(place, height, phases, depthToSun, extinctionAt(place));
#else
    vec3 light = scatteredLightAt(height, phases, depthToSun);
#endif
    march.gathered.sun += segment.opacity * light.x * sunOverLand(place);
    march.gathered.sky += segment.opacity * light.y;
    march.gathered.ground += segment.opacity * light.z;
#endif
    march.gathered.weight += segment.opacity;
    march.gathered.distance += segment.moment;
  }
}

// The segment of a ray in which there can be cloud: in the layer (LAYERS: in the tile's spans), before the scene's
// surface, not yet faded.
#ifdef LAYERS
RaySpan spanOfRay(vec3 direction, float surfaceM, Task task) {
  return make_raySpan(task.begin, min(min(task.end, surfaceM), clouds.layer.z));
}
#else
RaySpan spanOfRay(vec3 direction, float surfaceM, Task task) {
  float bend = rayBend(direction);
  RaySpan layer = bentRayInLayer(bentRayUnder(-clouds.layer.x - clouds.layer.y, direction.y, bend),
                                 bentRayUnder(-clouds.layer.x, direction.y, bend), min(task.end, surfaceM));
  return overlap(layer, make_raySpan(task.begin, task.end));
}
#endif
