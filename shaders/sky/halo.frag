#include "sky/halo.glsl"

in vec2 ndc;
out vec4 color;

void main() { color = vec4(haloTowards(normalize((frame.ndcToRay * vec4(ndc, 1.0, 0.0)).xyz)), 0.0); }
