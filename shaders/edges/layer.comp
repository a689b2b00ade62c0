#include "edges/layer.glsl"

layout(local_size_x = 16) in;

void main() { clearLayer(ivec2(gl_GlobalInvocationID.yx)); }
