#include "spray/dust.glsl"

out vec2 corner;
flat out vec4 look;
out vec3 relative;
flat out vec3 airLeft;
flat out vec3 airAdded;

void main() {
  Puff puff = puffCorner(gl_VertexID);
  gl_Position = puff.position;
  corner = puff.corner;
  look = puff.look;
  relative = puff.place;
  airAdded = airBefore(puff.place);
  airLeft = airLeftOf(puff.place, airAdded);
}
