// Optical depth from a place to the top of the layer, or of all layers, towards the sun.
#include "clouds/field.glsl"

uniform int sunSamples;

#ifdef LAYERS
// Of one layer, from where the ray enters its shell: as many samples as for one alone.
float sunDepthIn(const int i, vec3 place) {
  float height = heightIn(clouds.layers[i], place);
  float before = max(-height, 0.0) * clouds.layers[i].shell.y / clouds.toSun.y;
  float way = clamp(1.0 - height, 0.0, 1.0) * clouds.layers[i].shell.y / clouds.toSun.y;
  float parts = float(sunSamples);
  float depth = 0.0;
  int count = way > 0.0 ? sunSamples : 0;
  for (int k = 0; k < count; ++k) {
    float begin = sunPartBegin(float(k), parts, way);
    float end = sunPartBegin(float(k + 1), parts, way);
    depth += extinctionAt(clouds.layers[i], place + clouds.toSun.xyz * (before + 0.5 * (begin + end))) * (end - begin);
  }
  return depth;
}

float sunDepth(vec3 place) {
  float depth = 0.0;
#define DEPTH(i) depth += sunDepthIn(i, place);
  EACH_LAYER(DEPTH)
#undef DEPTH
  return depth;
}

// Of the layers that do not hold the place.
float sunDepthOfOthers(vec3 place) {
  float depth = 0.0;
#define DEPTH(i) depth += isInShell(heightIn(clouds.layers[i], place)) ? 0.0 : sunDepthIn(i, place);
  EACH_LAYER(DEPTH)
#undef DEPTH
  return depth;
}
#else

float sunDepth(vec3 place, float height) {
  float way = max(1.0 - height, 0.0) * clouds.layer.y / clouds.toSun.y;
  float parts = float(sunSamples);
  float depth = 0.0;
  for (int i = 0; i < sunSamples; ++i) {
    float begin = sunPartBegin(float(i), parts, way);
    float end = sunPartBegin(float(i + 1), parts, way);
    vec3 at = place + clouds.toSun.xyz * (0.5 * (begin + end));
    depth += extinctionAt(at) * (end - begin);
  }
  return depth;
}
#endif
