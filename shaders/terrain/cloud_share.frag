// What clouds leave of the sun at the pixels of the land.
#include "clouds/shadow_map.glsl"
#include "terrain/surface.glsl"

out float share;

void main() { share = sunThroughClouds(landPlace(ivec2(gl_FragCoord.xy))); }
