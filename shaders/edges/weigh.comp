#include "edges/weigh.glsl"

layout(local_size_x = 64) in;

void main() { weighListed(indexInList(gl_WorkGroupID, gl_LocalInvocationIndex)); }
