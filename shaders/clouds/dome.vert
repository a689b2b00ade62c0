#include "clouds/dome_air.glsl"

layout(location = 0) in vec3 direction;
layout(location = 1) in float alpha;

out vec3 ray;
out float rim;
out vec3 airLeft;

void main() {
  ray = direction;
  rim = alpha;
  airLeft = domeAirLeft(direction);
  gl_Position = frame.viewProjection * vec4(direction, 0.0);
}
