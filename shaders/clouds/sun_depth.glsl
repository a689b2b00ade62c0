// Optical depth from a place to the top of the layer, towards the sun.
#include "clouds/field.glsl"

uniform int sunSamples;

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
