#include "lightning/glow.glsl"

in vec2 ndc;
out vec4 color;

void main() { color = vec4(flashGlow(ndc), 0.0); }
