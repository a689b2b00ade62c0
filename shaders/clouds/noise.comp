#include "shared/dialect.glsl"
#include "shared/guards.glsl"
#include "shared/hash.glsl"
#include "shared/lattice_noise.glsl"
#include "shared/cloud_noise.glsl"
#include "clouds/noise.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

void main() { fillTexel(gl_GlobalInvocationID); }
