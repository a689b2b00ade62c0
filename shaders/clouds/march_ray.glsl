// Marches the ray of a texel of the pictures of rays, raySpacing pixels apart, to the surface that it meets.
#include "clouds/march.glsl"
#include "clouds/resolve.glsl"
#include "clouds/tiles.glsl"
#include "clouds/view.glsl"

layout(binding = 0, rgba16f) uniform writeonly image2D light;   // rgb, transmittance
layout(binding = 1, r16f) uniform writeonly image2D distances;  // mean of the light's

uniform ivec2 tileCount;
uniform int raySpacing;

// A ray beyond the picture's edge has the depth of the pixel at the edge.
void marchRayOf(ivec2 texel) {
  ivec2 pixel = texel * raySpacing;
  vec3 ray = rayThrough(vec2(pixel) + 0.5);
  vec3 direction = normalize(ray);
  ivec2 tile = pixel / TILE_SIDE;
  Gathered gathered = marchRay(direction, (tile.y * tileCount.x + tile.x) * kPlacesOfSpans,
                               sceneDistance(depthAt(pixel), ray));
  imageStore(light, texel, seenCloud(gathered, direction));
  imageStore(distances, texel, vec4(seenDistance(gathered)));
}
