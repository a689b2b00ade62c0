#include "frame.glsl"
#include "shared/cloud_medium.glsl"
#include "shared/cloud_light.glsl"
#include "clouds/uniforms.glsl"
#include "clouds/field.glsl"
#include "clouds/light_grid.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

void main() { fillColumn(ivec2(gl_GlobalInvocationID.xy)); }
