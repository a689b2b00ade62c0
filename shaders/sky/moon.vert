#include "sky/moon.glsl"

out vec3 direction;

void main() {
  direction = moonCorner(gl_VertexID);
  gl_Position = frame.viewProjection * vec4(direction, 0.0);
}
