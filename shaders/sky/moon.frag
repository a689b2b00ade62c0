#include "sky/moon.glsl"

in vec3 direction;
out vec4 color;

void main() { color = vec4(moonInPixel(direction, dFdx(direction), dFdy(direction)), 0.0); }
