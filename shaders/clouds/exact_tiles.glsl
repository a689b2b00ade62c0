// Marches the rays of a listed tile. MULTI_DISPATCH: as far as one dispatch may go, from where the one before came to.
#include "clouds/view.glsl"
#include "clouds/tiles.glsl"
#include "clouds/exact_march.glsl"
#include "clouds/resolve.glsl"

layout(std430, binding = 0) buffer Tiles {
  uvec4 groups;
  uvec4 groupsOfFour;
  Task tasks[];
} tiles;

layout(binding = 0, rgba16f) uniform writeonly image2D light;       // rgb, transmittance
layout(binding = 1, r16f) uniform writeonly image2D distances;       // mean of the light's

#ifdef MULTI_DISPATCH
layout(binding = 2, rgba32f) uniform image2D rayLight;  // sun, sky, ground (LAYERS: light), transmittance
layout(binding = 3, rgba32f) uniform image2D rayState;    // weight, distance, at, clear
layout(std430, binding = 2) buffer UnderWay { uint raysUnderWay; };

March begunMarch(ivec2 at, float begin) {
  vec4 l = imageLoad(rayLight, at);
  vec4 w = imageLoad(rayState, at);
#ifdef LAYERS
  Gathered gathered = Gathered(l.xyz, l.w, w.x, w.y);
#else
  Gathered gathered = Gathered(l.x, l.y, l.z, l.w, w.x, w.y);
#endif
  return March(gathered, max(w.z, alignedBefore(begin, 1.0)), w.w);
}

void keepMarch(ivec2 at, March march, RaySpan span) {
  Gathered g = march.gathered;
#ifdef LAYERS
  imageStore(rayLight, at, vec4(g.light, g.transmittance));
#else
  imageStore(rayLight, at, vec4(g.sun, g.sky, g.ground, g.transmittance));
#endif
  imageStore(rayState, at, vec4(g.weight, g.distance, march.at, march.clear));
  if (isUnderWay(march, span)) atomicAdd(raysUnderWay, 1u);
}
#else
March begunMarch(ivec2 at, float begin) { return marchFrom(begin); }
void keepMarch(ivec2 at, March march, RaySpan span) {}
#endif

void marchTile(uint index, uint invocation) {
  if (index >= tiles.groups.w) return;
  Task task = tiles.tasks[index];
  ivec2 pixel = taskPlace(task) * TILE_SIDE + placeInSquare(invocation, uint(TILE_SIDE));
  vec3 ray = rayThrough(vec2(pixel) + 0.5);
  vec3 direction = normalize(ray);
  RaySpan span = spanOfRay(direction, sceneDistance(depthAt(pixel), ray), task);
  March march = begunMarch(pixel, span.begin);
  marchOn(march, direction, span);
  keepMarch(pixel, march, span);
  imageStore(light, pixel, seenCloud(march.gathered, direction));
  imageStore(distances, pixel, vec4(seenDistance(march.gathered)));
}
