// A layer of ice along a ray: its light and opacity, multiplied together, as if nothing stood before it
// (render::IceCloudsPass). Compiled with CIRRUS, CIRROSTRATUS or CIRROCUMULUS, and with HALO where regular crystals count.
#include "clouds/ice_density.glsl"
#include "clouds/ice_ray.glsl"
#ifdef HALO
#include "sky/halo_phase.glsl"
uniform float regularShare;  // of the ice
#endif

uniform float iceExtinction; // of a density of 1, 1/m
uniform int iceSamples;
uniform vec4 sunAtPlaces[16];  // on ice from 400 km away from the sun to 400 km towards it: rgb illuminance, a sine of
                               // the sun's elevation there

const float kSunReachM = 400000.0;
// Rays of a low sun pass through no more of a layer than this many times its upright depth.
const float kLeastSine = 0.1;

vec4 sunOnIce(vec2 level) {
  vec2 towards = frame.toSun.xz * inversesqrt(max(dot(frame.toSun.xz, frame.toSun.xz), 1e-12));
  float at = saturate(0.5 + 0.5 * dot(level, towards) / kSunReachM) * 15.0;
  int low = min(int(at), 14);
  return mix(sunAtPlaces[low], sunAtPlaces[low + 1], at - float(low));
}

// A way after which air is about half opaque: distances are averaged by what it does to light.
const float kAirM = 40000.0;

// Optical depth along the ray, and the mean distance of what is seen of it.
vec2 iceDepth(vec3 direction, IceStretch way, float pixelAngle) {
  float bend = rayBend(direction);
  vec2 level = inIceAxes(direction.xz);
  float levelM = sqrt(dot(level, level));  // a metre along the ray
  vec2 unit = level / max(levelM, 1e-6);
  IcePlace eye = iceOrigin();
  float thickness = iceLevels.x - iceLevels.y;
  float last = icePlaceOnStretch(way, 0.0), sum = 0.0, left = 1.0, distances = 0.0;
  for (int i = 0; i < iceSamples; ++i) {
    float end = icePlaceOnStretch(way, float(i + 1) / float(iceSamples));
    float at = iceDistance(way, 0.5 * (last + end));
    float slope = abs(direction.y + 2.0 * bend * at);
    float across = pixelAngle * at;
    // What a sample stands for: the pixel laid on the layer, and a part of the way to the next sample.
    float along = max(min(across / max(slope, 1e-4), end - last), 0.4 * (end - last));
    along = max(along * levelM, across);
    vec2 extent = abs(unit) * along + abs(unit.yx) * across;
    float aboveTop = iceLevels.y + (direction.y + bend * at) * at;
    float depth = saturate(-aboveTop / thickness);
    float part = iceDensity(iceMoved(eye, level * at), depth, extent) * (end - last) * iceExtinction;
    float seen = left * stepOpacity(part);
    distances += seen * at / (at + kAirM);
    left -= seen;
    sum += part;
    last = end;
  }
  float mean = left < 1.0 ? min(distances / (1.0 - left), 0.99) : 0.0;
  return vec2(sum, left < 1.0 ? kAirM * mean / (1.0 - mean) : way.begin);
}

vec3 iceSource(vec3 direction, float distanceM, float upright) {
  vec4 sun = sunOnIce(direction.xz * distanceM);
  float sunDepth = 0.5 * upright / max(sun.a, kLeastSine);
  float left = exp(-sunDepth);
  vec3 phase = vec3(icePhase(dot(direction, frame.toSun.xyz)));
#ifdef HALO
  float degrees = angleBetween(direction, frame.toSun.xyz) / kDegree;
  phase += crystalPhase(direction, min(degrees, kHaloTo)) * (degrees < kHaloTo ? regularShare : 0.0);
#endif
  // Light that the ice above has scattered comes from all sides, half of it on downwards.
  vec3 once = phase * left + (1.0 - left) * (0.7 / (4.0 * kPi));
  vec3 around = (frame.skyLight.xyz + frame.groundLight.xyz) / (2.0 * kPi);
  return sun.rgb * once + around;
}

vec4 iceLight(vec3 direction, float pixelAngle) {
  IceStretch way = iceRay(direction);
  if (!(way.end > way.begin)) return vec4(0.0);
  vec2 depth = iceDepth(direction, way, pixelAngle);
  float bend = rayBend(direction);
  float rise = (direction.y + bend * depth.y) * depth.y;
  float upright = depth.x * (iceLevels.x - iceLevels.y) / (way.end - way.begin);
  vec3 light = min(iceSource(direction, depth.y, upright), vec3(kBrightest));
#ifdef HAZE
  vec3 left = airTransmittance(rise, depth.y);
  light = light * left + airRadiance(direction, depth.y) * (1.0 - left);
#endif
  return vec4(min(light, vec3(kBrightest)), 1.0) * stepOpacity(depth.x);
}
