#include "terrain/patch.glsl"

void main() { gl_Position = frame.viewProjection * vec4(patchVertex(gl_VertexID), 1.0); }
