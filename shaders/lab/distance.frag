#include "lab/distance.glsl"

out vec4 color;

void main() { color = vec4(encoded(pageColor(gl_FragCoord.xy)), 1.0); }
