// The shade of mountains on the surface that a pixel sees first: land or sea.
#include "shadow/land_shadow_map.glsl"
#include "terrain/surface.glsl"

vec3 surfacePlace(ivec2 pixel) {
  vec2 ndc = (vec2(pixel) + 0.5) * frame.viewport.zw * 2.0 - 1.0;
  vec3 ray = (frame.ndcToRay * vec4(ndc, 1.0, 0.0)).xyz;
  float seaViewZ = eyeFromBase.y > 0.0 ? eyeFromBase.y / max(-ray.y, 1e-7) : 1e9;
  return ray * min(landViewZ(pixel), min(seaViewZ, 1e9));
}

// FIRST_SHARES: in place of an open sky's shares, which a software renderer does in less time than to multiply them.
#ifdef FIRST_SHARES
const vec3 kBefore = kOpenSky;
#else
const vec3 kBefore = vec3(1.0);
#endif

vec3 sharesPastLand(ivec2 pixel) { return kBefore * vec3(sunPastLand(surfacePlace(pixel)), 1.0, 1.0); }
