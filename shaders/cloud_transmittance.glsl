// What clouds let through of whatever is drawn after them and may lie behind (render::CloudTransmittance). Programs are
// compiled with CLOUD_TRANSMITTANCE in frames that have clouds.
#include "frame.glsl"

#ifdef CLOUD_TRANSMITTANCE
layout(binding = 2) uniform sampler2D cloudLight;      // a: the share of light behind that comes through
layout(binding = 3) uniform sampler2D cloudDistances;  // x: where the clouds are

// What clouds leave of something at a distance: all of it in front of them, what they let through behind.
float throughClouds(float distanceM) {
  vec2 at = gl_FragCoord.xy * frame.viewport.zw;
  float cloudM = texture(cloudDistances, at).x;
  return mix(1.0, texture(cloudLight, at).a, smoothstep(0.9 * cloudM, 1.1 * cloudM, distanceM));
}
#else
float throughClouds(float distanceM) { return 1.0; }
#endif
