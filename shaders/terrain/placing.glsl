// What placing instances on the land has in common, whatever they are: the light that reaches a place, the view, a draw of
// a list (ARB_draw_indirect).
#include "terrain/land.glsl"
#include "shared/cloud_light.glsl"  // before what is conditional: a file is included once
#ifdef CLOUD_SHADE
#include "clouds/shadow_map.glsl"
#endif
#ifdef LAND_SHADE
#include "shadow/land_shadow_map.glsl"
#endif
#ifdef ICE_SHADE
#include "clouds/ice_shade_map.glsl"
#endif

struct DrawCommand {
  uint count;
  uint instanceCount;
  uint firstIndex;
  int baseVertex;
  uint baseInstance;
};

vec3 sharesAt(vec3 relative) {
  vec3 shares = kOpenSky;
#ifdef CLOUD_SHADE
  shares = lightThroughClouds(relative);
#endif
#ifdef LAND_SHADE
  shares.x *= sunPastLand(relative);
#endif
#ifdef ICE_SHADE
  shares *= lightBelowIce(relative).xyx;
#endif
  return shares;
}

// Of a lamp and a flash together: illuminance of what faces them, and what of it something round or thin as leaves and
// blades has in the mean over its sides that are seen (a ball, lit from where one looks: 2/3).
const float kLampShare = 0.6666667;

vec3 lampsAt(vec3 relative) {
  vec3 light = vec3(0.0);
#ifdef SPOT_LIGHT
  vec3 toLamp = spotPlace - relative;
  light += spotOn(relative, toLamp / max(length(toLamp), 1e-3));
#endif
#ifdef FLASH_LIGHT
  for (int i = 0; i < kFlashLights; ++i) light += flashOnFrom(i, relative, flashTowards(i, relative));
#endif
  return light * kLampShare;
}

// Share of what is open to the sky there that snow covers, [0, 1].
float lyingSnowAt(float heightM, LandNoise noise) {
#ifdef FALLEN_WATER
  return fallenSnow(fallen.y, heightM, fallen.z, 1.0, driftNoise(noise));
#else
  return 0.0;
#endif
}

// Whether a ball may be seen.
bool isInView(vec3 middle, float radiusM) {
  vec4 clip = frame.viewProjection * vec4(middle, 1.0);
  vec2 slack = radiusM * vec2(length(vec3(frame.viewProjection[0].x, frame.viewProjection[1].x, frame.viewProjection[2].x)),
                              length(vec3(frame.viewProjection[0].y, frame.viewProjection[1].y, frame.viewProjection[2].y))) +
               radiusM;
  return clip.w > -radiusM && all(lessThan(abs(clip.xy), vec2(clip.w) + slack));
}
