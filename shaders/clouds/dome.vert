#include "frame.glsl"

layout(location = 0) in vec3 direction;
layout(location = 1) in float alpha;

out vec3 ray;
out float rim;

void main() {
  ray = direction;
  rim = alpha;
  gl_Position = frame.viewProjection * vec4(direction, 0.0);
}
