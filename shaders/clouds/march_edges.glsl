// Marches single rays to the surface that each of them meets, and lays what they see over the scene.
layout(std430, binding = 0) readonly buffer Tiles {
  uvec4 groups;
  Task tasks[];
} tiles;
layout(std430, binding = 1) readonly buffer Edges {
  uvec4 groups;
  uint pixels[];
} edges;

layout(binding = 0, rgba16f) uniform image2D scene;

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
  vec4 cloud = seenCloud(march, direction);
  vec4 before = imageLoad(scene, pixel);
  imageStore(scene, pixel, vec4(before.xyz * cloud.w + cloud.xyz, before.w));
}
