// Marches the rays of a listed tile. MULTI_DISPATCH: as far as one dispatch may go, from where the one before came to.
#include "clouds/view.glsl"
#include "clouds/tiles.glsl"
#include "clouds/resolve.glsl"

layout(std430, binding = 0) buffer Tiles {
  uvec4 groups;
  Task tasks[];
} tiles;

layout(binding = 0, rgba16f) uniform writeonly image2D light;       // rgb, transmittance
layout(binding = 1, rg16f) uniform writeonly image2D distances;     // mean of the light's; the surface's

#ifdef MULTI_DISPATCH
layout(binding = 2, rgba32f) uniform image2D rayLight;  // sun, sky, ground, transmittance
layout(binding = 3, rgba32f) uniform image2D rayState;    // weight, distance, at, clear
layout(std430, binding = 2) buffer UnderWay { uint raysUnderWay; };

March begunMarch(ivec2 at, float begin) {
  vec4 l = imageLoad(rayLight, at);
  vec4 w = imageLoad(rayState, at);
  return March(l.x, l.y, l.z, l.w, w.x, w.y, max(w.z, alignedBefore(begin)), w.w);
}

void keepMarch(ivec2 at, March march, RaySpan span) {
  imageStore(rayLight, at, vec4(march.sun, march.sky, march.ground, march.transmittance));
  imageStore(rayState, at, vec4(march.weight, march.distance, march.at, march.clear));
  if (isUnderWay(march, span)) atomicAdd(raysUnderWay, 1u);
}
#else
March begunMarch(ivec2 at, float begin) { return marchFrom(begin); }
void keepMarch(ivec2 at, March march, RaySpan span) {}
#endif

void marchTile(uint index, uint invocation) {
  if (index >= tiles.groups.w) return;
  Task task = tiles.tasks[index];
  ivec2 at = taskPlace(task) * kTileSide + placeInTile(invocation);
  ivec2 pixel = at * DIVISOR;
  vec3 ray = rayThrough(vec2(pixel) + 0.5 * float(DIVISOR));
  vec3 direction = normalize(ray);
  float surface = sceneDistance(farthestDepth(pixel, DIVISOR), ray);
  RaySpan span = spanOfRay(direction, surface, task);
  March march = begunMarch(at, span.begin);
  marchOn(march, direction, span);
  keepMarch(at, march, span);
  imageStore(light, at, seenCloud(march, direction));
  imageStore(distances, at, vec4(seenDistance(march), min(surface, kFarDistance), 0.0, 0.0));
}
