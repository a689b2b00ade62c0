// The air behind a caster: a box that widens as the sun's rays spread, drawn without a vertex buffer.
#include "models/box.glsl"
#include "shadow/cast_shadows.glsl"

uniform vec4 volumeBegin;  // middle of the end towards the sun, relative to the eye; half width
uniform vec4 volumeEnd;

void main() {
  vec3 corner = boxCorner(gl_VertexID, vec3(-1.0, -1.0, 0.0), vec3(1.0));
  // right x up points to the sun: the far end is where the box's z is low.
  vec4 end = mix(volumeEnd, volumeBegin, corner.z);
  vec3 relative = end.xyz + (casterRight.xyz * corner.x + casterUp.xyz * corner.y) * end.w;
  gl_Position = frame.viewProjection * vec4(relative, 1.0);
}
