// What one caster leaves of the sun, and all of the sky, at the pixels of the land where its shadow may fall.
#include "shadow/cast_shadows.glsl"
#include "terrain/surface.glsl"

out vec3 shares;

void main() {
  BehindCaster at = behindCaster(landPlace(ivec2(gl_FragCoord.xy)));
  if (!mayBeInShadow(at)) discard;
  shares = vec3(shareOfSun(at), 1.0, 1.0);
}
