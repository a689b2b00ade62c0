#include "clouds/march_edges.glsl"

layout(local_size_x = 64) in;

void main() { marchEdge((gl_WorkGroupID.y * kGroupsARow + gl_WorkGroupID.x) * 64u + gl_LocalInvocationIndex); }
