#include "shared/cloud_light.glsl"
#include "clouds/compose.glsl"

layout(local_size_x = 64) in;

void main() { composeTile(gl_WorkGroupID.y * kGroupsARow + gl_WorkGroupID.x, gl_LocalInvocationIndex); }
