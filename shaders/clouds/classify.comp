#include "clouds/classify.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform ivec2 tileCount;

void main() { classifyTile(ivec2(gl_GlobalInvocationID.xy), tileCount); }
