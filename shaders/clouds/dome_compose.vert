#include "frame.glsl"

layout(location = 0) in vec3 direction;

void main() { gl_Position = frame.viewProjection * vec4(direction, 0.0); }
