// Lays the clouds over the scene, for the tiles that were marched.
#include "clouds/uniforms.glsl"
#include "clouds/tiles.glsl"
#include "clouds/view.glsl"
#include "clouds/cover.glsl"

layout(std430, binding = 0) readonly buffer Tiles {
  uvec4 groups;
  Task tasks[];
} tiles;

layout(binding = 7) uniform sampler2D light;
layout(binding = 8) uniform sampler2D distances;  // mean of the light's; the surface's

#if DIVISOR > 1
// Rays whose surroundings do not tell what they meet: to be marched one by one.
layout(std430, binding = 1) buffer Edges {
  uvec4 groups;
  uint pixels[];
} edges;

// Surfaces count as alike where they lie in front of, or behind, all cloud of a tile; and within a tenth.
float likeness(float a, float b, Task task) {
  float nearer = clamp(min(a, b), task.begin, task.end);
  float farther = clamp(max(a, b), task.begin, task.end);
  return clamp(1.0 - 10.0 * (farther - nearer) / max(farther, 1e-3), 0.0, 1.0);
}

void composePixel(ivec2 pixel, uint tile, ivec2 pixelInTile) {
  Task task = tiles.tasks[tile];
  vec3 ray = rayThrough(vec2(pixel) + 0.5);
  float surface = sceneDistance(texelFetch(sceneDepth, pixel, 0).x, ray);
  vec2 at = (vec2(pixel) + 0.5) / float(DIVISOR) - 0.5;
  ivec2 corner = ivec2(floor(at));
  vec2 share = at - vec2(corner);
  ivec2 last = textureSize(light, 0) - 1;
  vec4 sum = vec4(0.0);
  vec4 least = vec4(1e9);
  vec4 most = vec4(-1e9);
  float weights = 0.0;
  for (int i = 0; i < 4; ++i) {
    ivec2 offset = ivec2(i & 1, i >> 1);
    ivec2 texel = clamp(corner + offset, ivec2(0), last);
    float there = texelFetch(distances, texel, 0).y;
    vec2 nearness = mix(1.0 - share, share, vec2(offset));
    float weight = nearness.x * nearness.y * likeness(surface, there, task);
    vec4 cloud = texelFetch(light, texel, 0);
    sum += cloud * weight;
    weights += weight;
    least = min(least, cloud);
    most = max(most, cloud);
  }
  vec4 spread = most - least;
  if (weights > 0.02 && max(max(spread.x, spread.y), max(spread.z, spread.w)) < clouds.sight.z) {
    cover(pixel, sum / weights);
    return;
  }
  uint index = atomicAdd(edges.groups.w, 1u);
  edges.pixels[index] = packedEdge(tile, pixelInTile);
  uint group = index / 64u;
  atomicMax(edges.groups.x, min(group + 1u, kGroupsARow));
  atomicMax(edges.groups.y, group / kGroupsARow + 1u);
}
#else
void composePixel(ivec2 pixel, uint tile, ivec2 pixelInTile) { cover(pixel, texelFetch(light, pixel, 0)); }
#endif

void composeTile(uint index, uint invocation) {
  if (index >= tiles.groups.w) return;
  ivec2 corner = taskPlace(tiles.tasks[index]) * (kTileSide * DIVISOR);
  ivec2 ofInvocation = placeInTile(invocation) * DIVISOR;
  ivec2 size = viewSize();
  for (int i = 0; i < DIVISOR * DIVISOR; ++i) {
    ivec2 inTile = ofInvocation + ivec2(i % DIVISOR, i / DIVISOR);
    ivec2 pixel = corner + inTile;
    if (pixel.x < size.x && pixel.y < size.y) composePixel(pixel, index, inTile);
  }
}
