// Marches the rays that shaders/clouds/refine.glsl has listed.
#include "clouds/march_ray.glsl"

layout(std430, binding = 3) readonly buffer Rays {
  uvec4 groups;
  uint texels[];
} rays;

void marchListed(uint index) {
  if (index >= rays.groups.w) return;
  ivec2 texel = unpackedPlace(rays.texels[index]);
  if (all(lessThan(texel, imageSize(light)))) marchRayOf(texel);
}
