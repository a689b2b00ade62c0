#include "noise/gradient_noise.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

void main() { fillValue(gl_GlobalInvocationID); }
