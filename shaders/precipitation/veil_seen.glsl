// The veil before what a pixel shows, by the depths of the corners around it.
#include "precipitation/veil.glsl"

layout(binding = 0) uniform sampler2D sceneDepth;

#ifdef CLOUD_TRANSMITTANCE
layout(binding = 2) uniform sampler2D cloudLight;      // render::CloudTransmittance
layout(binding = 3) uniform sampler2D cloudDistances;

// throughClouds() of cloud_transmittance.glsl from single texels, which a software renderer reads in half the time.
float throughNearerClouds(float distanceM) {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float cloudM = texelFetch(cloudDistances, pixel, 0).x;
  return mix(1.0, texelFetch(cloudLight, pixel, 0).a, saturate(5.0 * distanceM / cloudM - 4.5));
}
#else
float throughNearerClouds(float distanceM) { return 1.0; }
#endif

// rayScale: length of the ray whose component along the view axis is 1, interpolated: within 1e-3.
vec4 veilBefore(Veil veil, float rayScale) {
  float lengthM = distanceOfDepth(texelFetch(sceneDepth, ivec2(gl_FragCoord.xy), 0).r, frame.eye.y, rayScale);
  float depth = dot(veil.depths, clamp(lengthM / veil.reachM * kSpanScales - kSpanOffsets, 0.0, 1.0));
  return vec4(veil.light, 1.0) * ((1.0 - exp(-depth)) * throughNearerClouds(veil.seenM));
}
