// Where a pixel's ray runs through a layer of ice, and what of the layer is seen past surfaces and volumes of cloud.
#include "cloud_transmittance.glsl"
#include "frame.glsl"
#include "shared/ice_clouds.glsl"

uniform vec2 iceLevels;  // of the eye above base and top, m

IceStretch iceRay(vec3 direction) { return iceStretch(iceLevels.x, iceLevels.y, frame.eye.x, direction); }

// Opacity of a share of what has an opacity as a whole.
float partOfOpacity(float opacity, float share) { return 1.0 - pow(max(1.0 - opacity, 1e-6), share); }

// Share of the layer on a ray that lies before a distance.
#ifdef SKY_ALONE
// From below, by height alone.
float iceShareBefore(vec3 direction, float distanceM) {
  float riseM = (direction.y + rayBend(direction) * distanceM) * distanceM;
  return saturate((riseM + iceLevels.x) / (iceLevels.x - iceLevels.y));
}
vec4 iceBeforeSurfaces(vec4 light, vec3 direction, float rayScale) { return light; }
#else
layout(binding = 4) uniform sampler2D sceneDepth;

float iceShareBefore(vec3 direction, float distanceM) {
  IceStretch way = iceRay(direction);
  return saturate((iceCount(way, distanceM) - way.begin) / max(way.end - way.begin, 1.0));
}
vec4 iceBeforeSurfaces(vec4 light, vec3 direction, float rayScale) {
  float depth = texelFetch(sceneDepth, ivec2(gl_FragCoord.xy), 0).r;
  float share = iceShareBefore(direction, distanceOfDepth(depth, frame.eye.y, rayScale));
  return light * (partOfOpacity(light.a, share) / max(light.a, 1e-6));
}
#endif

// A layer's light and opacity as blended over the scene: the part of it before volumes of cloud hides these, the part
// behind them only what they let through. (The scene is clouds + left * behind, so it takes no second picture to tell.)
vec4 iceOverScene(vec4 light, vec3 ray) {
  float rayScale = length(ray);
  vec3 direction = ray / rayScale;
  light = iceBeforeSurfaces(light, direction, rayScale);
#ifdef CLOUD_TRANSMITTANCE
  vec2 at = gl_FragCoord.xy * frame.viewport.zw;
  vec4 clouds = texture(cloudLight, at);
  float before = clouds.a < 1.0 ? iceShareBefore(direction, texture(cloudDistances, at).x) : 1.0;
  float front = partOfOpacity(light.a, before);
  float back = (light.a - front) / max(1.0 - front, 1e-6);
  vec3 source = light.rgb / max(light.a, 1e-6);
  vec3 behind = back * (clouds.rgb + source * clouds.a);
  return vec4(source * front + behind * (1.0 - front), light.a);
#else
  return light;
#endif
}
