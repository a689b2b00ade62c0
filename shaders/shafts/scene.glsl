// What lies in a pixel of the scene, for the passes of the shafts. Programs without CLOUD_TRANSMITTANCE know no clouds.
#include "frame.glsl"
#include "shared/light_shafts.glsl"

layout(binding = 0) uniform sampler2D sceneDepth;
#ifdef CLOUD_TRANSMITTANCE
layout(binding = 2) uniform sampler2D cloudLight;      // a: the share of light behind that comes through
layout(binding = 3) uniform sampler2D cloudDistances;  // x: where the clouds are
#endif

uniform int spacing;   // pixels a texel, on either side
uniform float topM;    // above it there is no shade
uniform float reachM;  // on the level, up to which shade counts

ivec2 viewSize() { return ivec2(frame.viewport.xy); }

// The pixel that a texel of the reduced picture stands for.
ivec2 pixelOf(ivec2 texel) { return min(texel * spacing + spacing / 2, viewSize() - 1); }

// Unnormalised: its component along the view axis is 1.
vec3 rayOf(ivec2 pixel) {
  vec2 ndc = (vec2(pixel) + 0.5) * frame.viewport.zw * 2.0 - 1.0;
  return (frame.ndcToRay * vec4(ndc, 1.0, 0.0)).xyz;
}

float sceneDistance(ivec2 pixel, float rayScale) {
  return distanceOfDepth(texelFetch(sceneDepth, pixel, 0).x, frame.eye.y, rayScale);
}

// Of the air that may be shaded, before what a ray of a slope ends at (sceneM), part of which clouds (cloudsIn) hide: what
// the ray loses is about as much as this.
vec3 airOpacity(float slope, float sceneM, vec2 clouds) {
  Atmosphere air = frameAtmosphere();
  float behindM = shaftSpan(frame.eye.x, slope, topM, reachM, sceneM).y;
  vec3 opacity = 1.0 - transmittanceBetween(air, frame.eye.x, frame.eye.x + slope * behindM, behindM);
#ifdef CLOUD_TRANSMITTANCE
  float cloudM = min(behindM, clouds.x);
  vec3 left = transmittanceBetween(air, frame.eye.x, frame.eye.x + slope * cloudM, cloudM);
  opacity = mix(1.0 - left, opacity, clouds.y);
#endif
  return opacity;
}

// Distance of the clouds before the scene (x), and what comes through them (y).
vec2 cloudsIn(ivec2 pixel) {
#ifdef CLOUD_TRANSMITTANCE
  vec2 at = (vec2(pixel) + 0.5) * frame.viewport.zw;
  return vec2(textureLod(cloudDistances, at, 0.0).x, textureLod(cloudLight, at, 0.0).a);
#else
  return vec2(kFarDistance, 1.0);
#endif
}
