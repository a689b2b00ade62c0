// What clouds and air send on of a flash of lightning, to be added to the scene. Programs are compiled with FLASH_LIGHT.
#include "frame.glsl"
#include "flash_light.glsl"

layout(binding = 0) uniform sampler2D sceneDepth;
#ifdef CLOUD_TRANSMITTANCE
layout(binding = 2) uniform sampler2D cloudLight;
layout(binding = 3) uniform sampler2D cloudDistances;
uniform float aboveBaseM;  // height of the flash above the base of its cloud
#endif

const float kMostGlow = 300.0;  // with channel and scene still a half float
const float kMostOfCloud = 1.1;  // that is shown of a cloud's glow: its shape is still seen
const float kFarthestAirM = 1e6;

#ifdef HAZE
vec3 glowOfAir(vec3 direction, float lengthM) {
  vec3 scattering = frame.columnHere.xyz + frame.columnHere.w * frame.airHaze.z;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < kFlashLights; ++i)
    sum += flashLights[i].xyz *
           (flashLights[i].w * flashAirlight(flashPlaces[i].xyz, direction, lengthM, flashPlaces[i].w));
  return sum * scattering / (4.0 * kPi);
}
#endif

#ifdef CLOUD_TRANSMITTANCE
vec3 glowOfCloud(vec3 direction, float cloudM) {
  vec3 place = direction * cloudM;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < kFlashLights; ++i) {
    vec3 way = flashPlaces[i].xyz - place;
    sum += flashLights[i].xyz * flashCloudGlow(dot(way, way), flashPlaces[i].w, aboveBaseM);
  }
#ifdef HAZE
  sum *= airTransmittance(place.y, cloudM);
#endif
  return sum;
}
#endif

vec3 flashGlow(vec2 ndc) {
  vec3 ray = (frame.ndcToRay * vec4(ndc, 1.0, 0.0)).xyz;
  float rayScale = length(ray);
  vec3 direction = ray / rayScale;
  float lengthM = distanceOfDepth(texelFetch(sceneDepth, ivec2(gl_FragCoord.xy), 0).r, frame.eye.y, rayScale);
  lengthM = min(lengthM, kFarthestAirM);
  vec3 glow = vec3(0.0);
#ifdef CLOUD_TRANSMITTANCE
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float cloudM = texelFetch(cloudDistances, pixel, 0).x, opacity = 1.0 - texelFetch(cloudLight, pixel, 0).a;
  vec3 cloud = glowOfCloud(direction, cloudM);
  float brightest = max(max(cloud.x, max(cloud.y, cloud.z)), 1e-20);
  glow += cloud * (flashAtMost(brightest, kMostOfCloud) / brightest * opacity);
  lengthM = mix(lengthM, min(lengthM, cloudM), opacity);
#endif
#ifdef HAZE
  glow += glowOfAir(direction, lengthM);
#endif
  return min(glow, vec3(kMostGlow));
}
