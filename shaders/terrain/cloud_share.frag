// What clouds leave of sun and sky at the pixels of the land.
#include "clouds/shadow_map.glsl"
#include "terrain/surface.glsl"

out vec3 shares;

void main() { shares = lightThroughClouds(landPlace(ivec2(gl_FragCoord.xy))); }
