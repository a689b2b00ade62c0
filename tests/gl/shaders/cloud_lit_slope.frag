// What a white slope below clouds receives, over a level square, a place a pixel.
#include "frame.glsl"
#include "shared/cloud_medium.glsl"
#include "shared/cloud_light.glsl"
#include "clouds/shadow_map.glsl"

uniform vec3 corner;    // of the square, relative to the eye
uniform float spacing;  // of its places, metres
uniform vec3 normal;    // of the slope

out vec4 color;

void main() {
  vec2 place = floor(gl_FragCoord.xy) * spacing;
  color = vec4(irradianceOf(normal, 1.0, lightThroughClouds(corner + vec3(place.x, 0.0, place.y))), 1.0);
}
