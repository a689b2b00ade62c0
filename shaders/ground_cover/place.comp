#include "ground_cover/place.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

void main() { placeCover(gl_WorkGroupID.x, gl_LocalInvocationIndex); }
