// Light that rain between the eye and what a pixel shows sends back (assets/scripts/make_rainbow.py has what the table is):
// the bows, and what is beside them. Added to the scene, clouds included.
#include "cloud_transmittance.glsl"
#include "frame.glsl"
#include "shared/atmospheric_optics.glsl"

layout(binding = 0) uniform sampler2D sceneDepth;
layout(binding = 1) uniform sampler2D rainbowTable;
uniform vec4 rain;           // extinction (1/m), where it begins and ends (m from the eye), its top (m)
uniform float dropRadiusMm;
uniform float lightShare;    // what clouds and land leave of the light on the rain

const float kRainbowTo = 90.0;  // degrees from the antisolar point

vec3 rainbowPhase(float degrees) {
  vec2 texels = vec2(textureSize(rainbowTable, 0));
  vec2 place = vec2(texturePlace(degrees, 0.0, kRainbowTo, texels.x),
                    texturePlace(rainbowRow(dropRadiusMm), 0.0, 1.0, texels.y));
  return textureLod(rainbowTable, place, 0.0).xyz;
}

vec3 rainbowTowards(vec2 ndc) {
  vec3 ray = (frame.ndcToRay * vec4(ndc, 1.0, 0.0)).xyz;
  float rayScale = length(ray);
  vec3 direction = ray / rayScale;
  float degrees = angleBetween(direction, -frame.toSun.xyz) / kDegree;
  if (degrees > kRainbowTo) return vec3(0.0);
  float lengthM = distanceOfDepth(texelFetch(sceneDepth, ivec2(gl_FragCoord.xy), 0).r, frame.eye.y, rayScale);
  vec2 path = rainPath(frame.eye.x, direction.y, lengthM, rain.y, rain.z, rain.w);
  if (path.y <= 0.0) return vec3(0.0);
  float seenM = path.x + 0.5 * min(path.y, 1.0 / rain.x);
  vec3 light = frame.sunLight.xyz * lightShare * airTransmittance(direction.y * seenM, seenM) * throughClouds(seenM);
  return min(light * rainbowPhase(degrees) * rainScattering(rain.x * path.y), vec3(kBrightest));
}
