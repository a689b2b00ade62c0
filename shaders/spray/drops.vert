#include "spray/drops.glsl"

out vec2 corner;
flat out vec4 look;
flat out vec2 shape;
flat out vec3 light;

void main() {
  Tuft tuft = tuftCorner(gl_VertexID);
  gl_Position = tuft.position;
  corner = tuft.corner;
  look = tuft.look;
  shape = tuft.shape;
  light = tuft.light;
}
