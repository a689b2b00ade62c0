#include "sky/stars.glsl"

flat in vec3 peak;
out vec4 color;

void main() { color = vec4(starAt(peak, (gl_PointCoord - 0.5) * (2.0 * kReachPixels)), 0.0); }
