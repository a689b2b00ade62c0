#include "spray/wake.glsl"

void main() { gl_Position = wakeCorner(gl_VertexID); }
