// Light and opacity of a target's mark at a pixel, multiplied together.
#include "cloud_transmittance.glsl"
#include "frame.glsl"
#include "shared/marker.glsl"

layout(binding = 0) uniform sampler2D sceneDepth;
uniform vec3 foot;            // the target, relative to the eye (m)
uniform float ringRadius;     // m
uniform float beamRadiusNow;  // m: one for the whole beam in a frame
uniform vec3 light;           // radiance as it reaches the eye: one for the whole part

// Stands for the distance of the sky where positions are subtracted: far beyond a ring, and its square is a float.
const float kRingFarthest = 1e6;

// The pixel's ray; its component along the view axis is 1.
vec3 pixelRay() {
  vec2 ndc = gl_FragCoord.xy * frame.viewport.zw * 2.0 - 1.0;
  return (frame.ndcToRay * vec4(ndc, 1.0, 0.0)).xyz;
}

float pixelDepth() { return texelFetch(sceneDepth, ivec2(gl_FragCoord.xy), 0).r; }

// Follows the land: each pixel asks how far from the target its own piece of ground is.
vec4 ringAt(vec3 ray, float depth) {
  vec3 place = ray * min(viewZOfDepth(depth, frame.eye.y), kRingFarthest);
  vec3 fromFoot = place - foot;
  float distanceM = length(fromFoot.xz);
  float footprint = length(vec2(dFdx(distanceM), dFdy(distanceM)));
  float coverage = ringCoverage(distanceM, ringRadius, footprint) * ringFade(fromFoot.y, ringRadius);
  return vec4(light, 1.0) * (coverage * throughClouds(length(place)));
}

// What stands in front of the beam, or in it, hides what is behind.
vec4 beamAt(vec3 ray, float depth) {
  float rayScale = length(ray);
  vec3 direction = ray / rayScale;
  vec2 inside = beamInterval(direction, foot, beamRadiusNow);
  float end = min(inside.y, distanceOfDepth(depth, frame.eye.y, rayScale));
  float opticalDepth = beamOpticalDepth(direction, foot, beamRadiusNow, inside.x, max(inside.x, end));
  float opacity = beamOpacity(opticalDepth);
  return vec4(light, 1.0) * (opacity * throughClouds(inside.x));
}
