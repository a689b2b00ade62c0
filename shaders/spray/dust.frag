#include "spray/dust_look.glsl"

in vec2 corner;
flat in vec4 look;
in vec3 relative;
flat in vec3 airLeft;
flat in vec3 airAdded;
out vec4 color;

void main() { color = puffSeen(corner, look, relative, airLeft, airAdded); }
