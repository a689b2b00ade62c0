// What clouds leave of the sun at the pixels of the land.
#include "frame.glsl"
#include "shared/cloud_medium.glsl"
#include "shared/cloud_light.glsl"
#include "clouds/shade.glsl"
#include "terrain/surface.glsl"

out float share;

void main() { share = cloudShade(landPlace(ivec2(gl_FragCoord.xy))); }
