// What clouds leave of the light of the sun (red; blue: straight) and the sky (green) on a level square, a place a pixel.
#include "frame.glsl"
#include "shared/cloud_medium.glsl"
#include "shared/cloud_light.glsl"
#include "clouds/shadow_map.glsl"

uniform vec3 corner;    // of the square, relative to the eye
uniform float spacing;  // of its places, metres

out vec4 color;

void main() {
  vec2 place = floor(gl_FragCoord.xy) * spacing;
  vec3 relative = corner + vec3(place.x, 0.0, place.y);
  color = vec4(sunThroughClouds(relative), skyThroughClouds(relative), lightThroughClouds(relative).x, 1.0);
}
