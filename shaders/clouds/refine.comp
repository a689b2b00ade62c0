#include "clouds/refine.glsl"

layout(local_size_x = 64) in;

void main() { refineTile(gl_WorkGroupID.y * kGroupsARow + gl_WorkGroupID.x, gl_LocalInvocationIndex); }
