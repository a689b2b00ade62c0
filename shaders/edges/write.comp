#include "edges/write.glsl"

layout(local_size_x = 64) in;

void main() { writeListed(indexInList(gl_WorkGroupID, gl_LocalInvocationIndex)); }
