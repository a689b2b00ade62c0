// Marches the rays of the listed tiles.
#include "clouds/march_ray.glsl"
#include "clouds/tile_rays.glsl"

void marchTile(uint group, uint invocation) {
  ivec2 texel;
  if (rayOfTile(group, invocation, imageSize(light), texel)) marchRayOf(texel);
}
