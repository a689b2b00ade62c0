// What clouds leave of sun and sky at the pixels of the land.
#include "clouds/shadow_map.glsl"
#include "terrain/surface.glsl"

out vec2 shares;

void main() {
  vec3 place = landPlace(ivec2(gl_FragCoord.xy));
  shares = vec2(sunThroughClouds(place), skyThroughClouds(place));
}
