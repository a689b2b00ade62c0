// What of the light reaches land and sea. LAND_SHADE: in frames in which mountains may take some of the sun's.
#include "terrain/surface.glsl"
#ifdef LAND_SHADE
#include "shadow/land_shadow_map.glsl"
#endif

// At a place of the land or the sea, relative to the eye, that a pixel shows; the sea's floor has the light of the surface
// before it.
vec3 lightSharesAt(ivec2 pixel, vec3 relative) {
  vec3 shares = keptSharesAt(pixel);
#ifdef LAND_SHADE
  float depthM = -(relative.y + eyeFromBase.y);
  vec3 surface = relative * (depthM > 0.0 && eyeFromBase.y > 0.0 ? eyeFromBase.y / -relative.y : 1.0);
  shares.x *= sunPastLand(surface);
#endif
  return shares;
}
