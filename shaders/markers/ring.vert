#include "frame.glsl"

layout(location = 0) in vec3 position;

uniform vec3 middle;
uniform vec3 extent;

void main() { gl_Position = frame.viewProjection * vec4(middle + position * extent, 1.0); }
