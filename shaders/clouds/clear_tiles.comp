#include "clouds/clear_tiles.glsl"

layout(local_size_x = 64) in;

void main() { clearTile(ivec2(gl_WorkGroupID.xy), ivec2(gl_NumWorkGroups.xy), gl_LocalInvocationIndex); }
