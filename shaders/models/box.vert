// The box around a ring or a beam, drawn without a vertex buffer: 14 vertices of one triangle strip.
#include "frame.glsl"
#include "models/box.glsl"

uniform vec3 boxLow;
uniform vec3 boxHigh;

void main() { gl_Position = frame.viewProjection * vec4(boxCorner(gl_VertexID, boxLow, boxHigh), 1.0); }
