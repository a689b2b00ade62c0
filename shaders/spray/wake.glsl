// The quadrangle on the sea that rings and wakes are drawn in (render::WakePass).
#include "frame.glsl"

uniform vec4 wakeBox;  // x, z of the corners relative to the eye (m): least, most

// A corner of the box on the sea, a little above it.
vec4 wakeCorner(int vertex) {
  vec2 at = mix(wakeBox.xy, wakeBox.zw, vec2(vertex & 1, vertex >> 1));
  return frame.viewProjection * vec4(at.x, -frame.eye.x, at.y, 1.0);
}
