#include "clouds/recall_rays.glsl"

layout(local_size_x = 64) in;

void main() { recallListed(gl_WorkGroupID.y * kGroupsARow + gl_WorkGroupID.x, gl_LocalInvocationIndex); }
