// The clouds' medium at a place relative to the eye, in the field: where a straight ray is bent (placeOnBentRay()). DETAIL:
// edges are eroded by the detail texture, else by its mean. LAYERS: of several layers.
#include "shared/cloud_medium.glsl"
#include "shared/cloud_light.glsl"
#include "clouds/far.glsl"
#include "clouds/uniforms.glsl"

layout(binding = 0) uniform sampler3D baseNoise;
layout(binding = 1) uniform sampler3D detailNoise;
layout(binding = 2) uniform sampler2D weatherMap;

#ifdef LAYERS
#include "clouds/union_field.glsl"
#else
CloudMedium frameMedium() {
  CloudMedium medium;
  medium.threshold = clouds.medium.x;
  medium.coverage = clouds.medium.y;
  medium.typeShift = clouds.medium.z;
  medium.erosion = clouds.medium.w;
  return medium;
}

// Height over the base by the thickness; clouds lie in (0, 1).
float heightFraction(vec3 place) { return (place.y - clouds.layer.x) / clouds.layer.y; }

vec3 periodsAt(vec3 place, vec4 eye) { return eye.xyz + place * eye.w; }

// Density before erosion, [0, 1]: nothing is where this is 0.
float shapeDensity(vec3 place, float height) {
  vec2 map = clouds.weatherPlace.xz + place.xz * clouds.weatherPlace.w;
  vec2 weather = textureLod(weatherMap, map, 0.0).xy;  // coverage, type
  float base = textureLod(baseNoise, periodsAt(place, clouds.shapePlace), 0.0).x;
  return cloudShapeDensity(frameMedium(), height, vec4(weather.x, 0.0, weather.y, 1.0), base);
}

float erodedDensity(vec3 place, float height, float shape) {
#ifdef DETAIL
  float detail = textureLod(detailNoise, periodsAt(place, clouds.detailPlace), 0.0).x;
#else
  float detail = clouds.scattering.z;
#endif
  return erodedDensity(frameMedium(), height, shape, detail);
}

// At a place on a ray.
struct MediumSample {
  float shape;       // cloudShapeEstimate()
  float extinction;  // 1/m; not faded with distance
};

float shapeEstimate(vec3 place, float height) {
  vec2 map = clouds.weatherPlace.xz + place.xz * clouds.weatherPlace.w;
  vec2 weather = textureLod(weatherMap, map, 0.0).xy;  // coverage, type
  float base = textureLod(baseNoise, periodsAt(place, clouds.shapePlace), 0.0).x;
  return cloudShapeEstimate(frameMedium(), height, weather.x, weather.y, base);
}

// detailShare: detailLeft().
MediumSample sampleAt(vec3 place, float detailShare) {
  float height = heightFraction(place);
  float shape = shapeEstimate(place, height);
#ifdef DETAIL
  float detail = textureLod(detailNoise, periodsAt(place, clouds.detailPlace), 0.0).x;
  detail = mix(clouds.farField.w, detail, detailShare);
#else
  float detail = clouds.scattering.z;
#endif
  return MediumSample(shape, erodedDensity(frameMedium(), height, max(shape, 0.0), detail) * clouds.layer.w);
}

// In the far field: eroded everywhere alike.
MediumSample farSampleAt(vec3 place) {
  float height = heightFraction(place);
  float shape = shapeEstimate(place, height);
  float density = erodedDensity(frameMedium(), height, max(shape, 0.0), clouds.farField.w);
  return MediumSample(shape, density * clouds.layer.w);
}

// Extinction, 1/m; not faded with distance.
float extinctionAt(vec3 place) {
  float height = heightFraction(place);
  return erodedDensity(place, height, shapeDensity(place, height)) * clouds.layer.w;
}
#endif
