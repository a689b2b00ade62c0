#include "edges/columns.glsl"

layout(local_size_x = 32) in;

void main() { turnTile(ivec2(gl_WorkGroupID.xy), gl_LocalInvocationIndex); }
