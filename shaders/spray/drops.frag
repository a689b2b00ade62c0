#include "spray/drops_look.glsl"

in vec2 corner;
flat in vec4 look;
flat in vec2 shape;
flat in vec3 light;
out vec4 color;

void main() { color = tuftSeen(corner, look, shape, light, look.z); }
