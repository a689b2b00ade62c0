#include "models/lamp_glow.glsl"

in vec2 pixelsAside;
flat in int lamp;
flat in float shown;
out vec4 color;

void main() { color = vec4(glowAt(lamp, pixelsAside) * shown, 0.0); }
