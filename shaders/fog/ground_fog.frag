#include "fog/ground_fog.glsl"

in vec2 ndc;
out vec4 color;

void main() { color = groundFog(ndc); }
