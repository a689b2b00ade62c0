// How much of a particle is seen: fading into what it touches, and behind clouds.
#include "cloud_transmittance.glsl"

layout(binding = 0) uniform sampler2D sceneDepth;

float shareBefore(float viewZ, float softM) {
  float scene = viewZOfDepth(texelFetch(sceneDepth, ivec2(gl_FragCoord.xy), 0).r, frame.eye.y);
  return saturate((scene - viewZ) / softM);
}

// Premultiplied: light of a unit of cover through the air, of an opacity.
vec4 seenParticle(vec3 light, vec3 airLeft, vec3 airAdded, float opacity) {
  return vec4(min(light * airLeft + airAdded, vec3(kBrightest)) * opacity, opacity);
}
