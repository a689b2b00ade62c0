// Optical depth from a place towards the sun. LIGHT_GRID: samples go toSun.w metres and the rest
// is looked up, else they go to the top of the layer.
#include "clouds/field.glsl"

uniform int sunSamples;

#ifdef LIGHT_GRID
layout(binding = 4) uniform sampler3D nearDepths;
layout(binding = 5) uniform sampler3D farDepths;

vec3 inGrid(vec4 rows[3], vec3 place) {
  vec4 at = vec4(place, 1.0);
  return vec3(dot(rows[0], at), dot(rows[1], at), dot(rows[2], at));
}

float gridDepth(vec3 place) {
  vec3 inNear = inGrid(clouds.nearGrid, place);
  float toEdge = 0.5 - max(abs(inNear.x - 0.5), abs(inNear.y - 0.5));
  float nearShare = smoothstep(0.0, 0.05, toEdge);
  float farDepth = textureLod(farDepths, inGrid(clouds.farGrid, place), 0.0).x;
  return mix(farDepth, textureLod(nearDepths, inNear, 0.0).x, nearShare);
}
#endif

float sunDepth(vec3 place, float height) {
  float way = max(1.0 - height, 0.0) * clouds.layer.y / clouds.toSun.y;
#ifdef LIGHT_GRID
  way = min(way, clouds.toSun.w);
#endif
  float parts = float(sunSamples);
  float depth = 0.0;
  for (int i = 0; i < sunSamples; ++i) {
    float begin = sunPartBegin(float(i), parts, way);
    float end = sunPartBegin(float(i + 1), parts, way);
    vec3 at = place + clouds.toSun.xyz * (0.5 * (begin + end));
    depth += extinctionAt(at) * (end - begin);
  }
#ifdef LIGHT_GRID
  depth += gridDepth(place + clouds.toSun.xyz * way);
#endif
  return depth;
}
