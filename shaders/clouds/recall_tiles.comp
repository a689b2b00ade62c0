#include "clouds/recall_tiles.glsl"

layout(local_size_x = GROUP_SIZE) in;

void main() { recallTile(gl_WorkGroupID.y * kGroupsARow + gl_WorkGroupID.x, gl_LocalInvocationIndex); }
