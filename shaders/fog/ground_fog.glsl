// Light and opacity of ground fog between the eye and what a pixel shows, multiplied together.
#include "cloud_transmittance.glsl"
#include "frame.glsl"
#include "shared/ground_fog.glsl"

layout(binding = 0) uniform sampler2D sceneDepth;
uniform float eyeAboveBaseM;
uniform float extinction;     // up to the base, 1/m
uniform float scaleHeightM;

const float kFogAlbedo = 0.8;       // of a thick layer that is lit from above
const float kFogForward = 0.8;      // anisotropy of light that droplets scatter once
const float kFogOnceShare = 0.05;   // of that in what leaves the fog
const float kFarthestFogM = 1e7;    // its square is a float

// Droplets scatter nearly all light and often: a matt layer under sun and sky, with a glow around the sun.
vec3 fogLight(vec3 direction) {
  vec3 onTop = frame.sunLight.xyz * max(frame.toSun.y, 0.0) + frame.skyLight.xyz;
  float once = henyeyGreenstein(dot(direction, frame.toSun.xyz), kFogForward);
  return min(onTop * (kFogAlbedo / kPi) + frame.sunLight.xyz * (kFogOnceShare * once), vec3(kBrightest));
}

vec4 groundFog(vec2 ndc) {
  vec3 ray = (frame.ndcToRay * vec4(ndc, 1.0, 0.0)).xyz;
  float rayScale = length(ray);
  vec3 direction = ray / rayScale;
  float lengthM = distanceOfDepth(texelFetch(sceneDepth, ivec2(gl_FragCoord.xy), 0).r, frame.eye.y, rayScale);
  float depth = extinction * groundFogPath(eyeAboveBaseM, direction.y * lengthM, lengthM, scaleHeightM);
  float seenDepth = clamp(0.5 * depth, 1e-6, 1.0);
  float seenM = groundFogDistance(eyeAboveBaseM, direction.y, seenDepth, extinction, scaleHeightM);
  seenM = min(min(seenM, lengthM), kFarthestFogM);
  vec3 light = applyAerialPerspective(fogLight(direction), direction * seenM);
  return vec4(light, 1.0) * (groundFogOpacity(depth) * throughClouds(seenM));
}
