#include "noise/volume.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

void main() { drawPixel(ivec2(gl_GlobalInvocationID.xy)); }
