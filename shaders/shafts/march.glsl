// Marches the rays of a reduced picture through shaded air.
#include "shafts/scene.glsl"
#ifdef CLOUD_SHADE
#include "clouds/shadow_map.glsl"
#endif
#ifdef LAND_SHADE
#include "shadow/land_shade_volume.glsl"
#endif
#include "shared/hash.glsl"

uniform int steps;
uniform float glow;                        // share of the light that air scatters with a direction
uniform vec4 sunAtHeights[kShaftHeights];  // rgb: illuminance on what faces the sun, times exposure

vec3 sunAt(float heightM) {
  float at = saturate(heightM / topM) * float(kShaftHeights - 1);
  int low = min(int(at), kShaftHeights - 2);
  return mix(sunAtHeights[low].xyz, sunAtHeights[low + 1].xyz, at - float(low));
}

// Shares of the sun's light at a place: straight, and out of the base of clouds.
vec2 lightOnAir(vec3 relative) {
  vec2 light = vec2(1.0, 0.0);
#ifdef CLOUD_SHADE
  vec2 shadow = sunDepthInClouds(relative);
  light = mix(light, shaftLight(shadow.x), shadow.y);
#endif
#ifdef LAND_SHADE
  light.x *= sunOverLand(relative);
#endif
  return mix(vec2(1.0, 0.0), light, shaftFade(length(relative.xz), reachM));
}

// Where the air is that below an even deck it has no sun to lose.
float shaftsLeft() {
#ifdef OVERCAST
  return 1.0 - frame.overcast.x;
#else
  return 1.0;
#endif
}

// Each of 4 x 4 neighbours begins its steps elsewhere, by an ordered pattern (Bayer 1973): those that the filter means
// together have 16 places a step.
float firstShare(ivec2 texel) {
  uint x = uint(texel.x), y = uint(texel.y), d = x ^ y;
  uint rank = ((d & 1u) << 3) | ((y & 1u) << 2) | (d & 2u) | ((y >> 1) & 1u);
  return (float(rank) + 0.5) / 16.0;
}

// rgb: light that the ray loses by the opacity of its air, a: that opacity, of green.
vec4 shaftsOf(ivec2 texel) {
  ivec2 pixel = pixelOf(texel);
  vec3 ray = rayOf(pixel);
  float rayScale = length(ray);
  vec3 direction = ray / rayScale;
  float sceneM = sceneDistance(pixel, rayScale);
  vec2 clouds = cloudsIn(pixel);
  vec2 span = shaftSpan(frame.eye.x, direction.y, topM, reachM, sceneM);
  if (clouds.y < kShaftOpaque) span.y = max(min(span.y, 1.1 * clouds.x), span.x);

  Atmosphere air = frameAtmosphere();
  float cosSun = dot(direction, frame.toSun.xyz);
  vec2 phases = glow * vec2(rayleighPhase(cosSun), henyeyGreenstein(cosSun, air.hazeAnisotropy)) +
                (1.0 - glow) * shaftMeanPhases(direction.y, frame.toSun.y);
  vec3 depth = opticalDepthBetween(air, frame.eye.x, frame.eye.x + direction.y * span.x, span.x);
  float first = firstShare(texel), from = span.x;
  vec3 loss = vec3(0.0);
  int count = span.y > span.x ? steps : 0;
  for (int i = 0; i < count; ++i) {
    float to = shaftPlace(span, float(i + 1) / float(steps));
    float heightM = frame.eye.x + direction.y * 0.5 * (from + to);
    ShellAir here = shellAirAt(air, heightM);
    float shift = fract(first + unitOf(hash2(uvec2(uint(i), 113u)).x));
    float atM = shaftPlace(span, (float(i) + shift) / float(steps));
    vec3 lost = shaftLoss(here, phases, lightOnAir(direction * atM), frame.toSun.y);
    float seen = mix(1.0, clouds.y, smoothstep(0.9 * clouds.x, 1.1 * clouds.x, atM));
    lost *= shaftsLeft();
    loss += exp(-(depth + here.extinction * (0.5 * (to - from)))) * sunAt(heightM) * lost * ((to - from) * seen);
    depth += here.extinction * (to - from);
    from = to;
  }
  vec3 opacity = airOpacity(direction.y, sceneM, clouds);
  return vec4(clamp(loss / max(opacity, vec3(1e-6)), vec3(-kBrightest), vec3(kBrightest)), opacity.g);
}
