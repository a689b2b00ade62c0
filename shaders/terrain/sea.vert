#include "terrain/sea.glsl"

void main() { gl_Position = frame.viewProjection * seaCorner(gl_VertexID); }
