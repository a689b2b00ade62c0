#include "frame.glsl"
#include "markers/beam.glsl"

layout(location = 0) in vec3 position;

out vec3 relative;
out vec2 onBeam;

void main() {
  relative = beamVertex(position);
  onBeam = position.xy;
  gl_Position = frame.viewProjection * vec4(relative, 1.0);
}
