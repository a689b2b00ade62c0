#include "frame.glsl"
#include "shared/cloud_medium.glsl"
#include "shared/cloud_light.glsl"
#include "clouds/uniforms.glsl"
#include "clouds/field.glsl"
#include "clouds/occupancy.glsl"
#include "clouds/sun_depth.glsl"
#include "clouds/view.glsl"
#include "clouds/tiles.glsl"
#include "clouds/march.glsl"
#include "clouds/resolve.glsl"
#include "clouds/cover.glsl"
#include "clouds/march_edges.glsl"

layout(local_size_x = 64) in;

void main() { marchEdge((gl_WorkGroupID.y * kGroupsARow + gl_WorkGroupID.x) * 64u + gl_LocalInvocationIndex); }
