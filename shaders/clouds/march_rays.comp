#include "clouds/march_rays.glsl"

layout(local_size_x = 64) in;

void main() { marchListed((gl_WorkGroupID.y * kGroupsARow + gl_WorkGroupID.x) * 64u + gl_LocalInvocationIndex); }
