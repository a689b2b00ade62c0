#include "sky/stars.glsl"

layout(location = 0) in vec3 place;
layout(location = 1) in vec3 light;
flat out vec3 peak;

void main() {
  vec3 direction = raised(toWorld * place);
  gl_Position = frame.viewProjection * vec4(direction, 0.0);
  gl_PointSize = 2.0 * kReachPixels;
  peak = starRadiance(direction, light, gl_Position.w, uint(gl_VertexID));
}
