#include "precipitation/drops.glsl"

out vec2 aside;
out float depth;
flat out vec2 halfSize;
flat out vec4 dropLight;

void main() {
  Streak streak = streakCorner(gl_VertexID, gl_InstanceID);
  gl_Position = streak.position;
  aside = streak.aside;
  depth = streak.depth;
  halfSize = streak.extent;
  dropLight = streak.light;
}
