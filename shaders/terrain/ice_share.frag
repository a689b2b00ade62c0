// What ice clouds leave of sun and sky at the pixels of the land.
#include "clouds/ice_shade_map.glsl"
#include "terrain/surface.glsl"

out vec3 shares;

void main() { shares = lightBelowIce(landPlace(ivec2(gl_FragCoord.xy))).xyx; }
