#include "edges/blend.glsl"

layout(local_size_x = 64) in;

void main() { blendListed(indexInList(gl_WorkGroupID, gl_LocalInvocationIndex)); }
