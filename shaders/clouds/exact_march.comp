#include "clouds/exact_tiles.glsl"

layout(local_size_x = 64) in;

void main() { marchTile(gl_WorkGroupID.y * kGroupsARow + gl_WorkGroupID.x, gl_LocalInvocationIndex); }
