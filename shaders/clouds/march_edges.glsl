// Marches single rays to the surface that each of them meets, and lays what they see over the scene.
#include "clouds/view.glsl"
#include "clouds/tiles.glsl"
#include "clouds/resolve.glsl"
#include "clouds/cover.glsl"

layout(std430, binding = 0) readonly buffer Tiles {
  uvec4 groups;
  Task tasks[];
} tiles;
layout(std430, binding = 1) readonly buffer Edges {
  uvec4 groups;
  uint pixels[];
} edges;

void marchEdge(uint index) {
  if (index >= edges.groups.w) return;
  uint edge = edges.pixels[index];
  Task task = tiles.tasks[tileOfEdge(edge)];
  ivec2 pixel = taskPlace(task) * (kTileSide * DIVISOR) + pixelOfEdge(edge);
  vec3 ray = rayThrough(vec2(pixel) + 0.5);
  vec3 direction = normalize(ray);
  RaySpan span = spanOfRay(direction, sceneDistance(texelFetch(sceneDepth, pixel, 0).x, ray), task);
  March march = marchFrom(span.begin);
  marchOn(march, direction, span);
  cover(pixel, seenCloud(march, direction));
}
