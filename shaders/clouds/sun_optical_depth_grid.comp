#include "clouds/sun_optical_depth_grid.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

void main() { fillColumn(ivec2(gl_GlobalInvocationID.xy)); }
