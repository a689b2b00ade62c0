#include "clouds/march_tiles.glsl"

layout(local_size_x = GROUP_SIZE) in;

void main() { marchTile(gl_WorkGroupID.y * kGroupsARow + gl_WorkGroupID.x, gl_LocalInvocationIndex); }
