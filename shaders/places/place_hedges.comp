#include "places/place_hedges.glsl"

layout(local_size_x = 8) in;

void main() { placeHedge(int(gl_WorkGroupID.x), int(gl_LocalInvocationID.x)); }
