// What one caster leaves of the sun at the pixels of the land where its shadow may fall.
#include "shadow/cast_shadows.glsl"
#include "terrain/surface.glsl"

out float share;

void main() {
  BehindCaster at = behindCaster(landPlace(ivec2(gl_FragCoord.xy)));
  if (!mayBeInShadow(at)) discard;
  share = shareOfSun(at);
}
