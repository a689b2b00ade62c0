#include "frame.glsl"
#include "shared/cloud_medium.glsl"
#include "shared/cloud_light.glsl"
#include "clouds/uniforms.glsl"
#include "clouds/tiles.glsl"
#include "clouds/view.glsl"
#include "clouds/cover.glsl"
#include "clouds/compose.glsl"

layout(local_size_x = 64) in;

void main() { composeTile(gl_WorkGroupID.y * kGroupsARow + gl_WorkGroupID.x, gl_LocalInvocationIndex); }
