// Share of the full rain below a place of the clouds (render::RainMap). Programs are compiled with RAIN_MAP in frames whose
// clouds leave gaps; without, it rains everywhere alike.
#include "shared/precipitation.glsl"

#ifdef RAIN_MAP
layout(binding = 5) uniform sampler2D rainMap;  // coverage, precipitation
uniform vec4 rainMapPlace;  // xy: the eye in periods; periods in a metre; coverage of the layer

// `aside`: from the eye, m; `widthM`: what is looked at there.
float rainShareAt(vec2 aside, float widthM) {
  float texels = float(textureSize(rainMap, 0).x);
  float level = log2(max(widthM * rainMapPlace.z * texels, 1.0));
  vec2 mapped = textureLod(rainMap, rainMapPlace.xy + aside * rainMapPlace.z, level).xy;
  return rainShareOfMap(mapped.x, mapped.y, rainMapPlace.w);
}
#else
float rainShareAt(vec2 aside, float widthM) { return 1.0; }
#endif
