#include "clouds/cover_tiles.glsl"

layout(local_size_x = 64) in;

void main() { coverTile(gl_WorkGroupID.y * kGroupsARow + gl_WorkGroupID.x, gl_LocalInvocationIndex); }
