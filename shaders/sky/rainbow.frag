#include "sky/rainbow.glsl"

in vec2 ndc;
out vec4 color;

void main() { color = vec4(rainbowTowards(ndc), 0.0); }
