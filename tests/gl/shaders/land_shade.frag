// What land leaves of the sun (red) on a level square, a place a pixel.
#include "shadow/land_shadow_map.glsl"

uniform vec3 corner;    // of the square, relative to the eye
uniform float spacing;  // of its places, metres

out vec4 color;

void main() {
  vec2 place = floor(gl_FragCoord.xy) * spacing;
  color = vec4(sunPastLand(corner + vec3(place.x, 0.0, place.y)), 0.0, 0.0, 1.0);
}
