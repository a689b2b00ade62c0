#include "frame.glsl"
#include "shared/lattice_noise.glsl"
#include "shared/water.glsl"
#include "terrain/surface.glsl"
#include "terrain/noise.glsl"
#include "terrain/sea.glsl"

void main() { gl_Position = frame.viewProjection * seaCorner(gl_VertexID); }
