// From rays twice as far apart to rays RAY_SPACING pixels apart, in the listed tiles: where they bend little, those between
// are interpolated; where they bend more, and where surfaces make a difference, they are listed to be marched.
#include "clouds/ray_list.glsl"
#include "clouds/tile_list.glsl"
#include "clouds/far.glsl"
#include "clouds/uniforms.glsl"
#include "clouds/view.glsl"

layout(binding = 7) uniform sampler2D coarseLight;
layout(binding = 8) uniform sampler2D coarseDistances;
layout(binding = 0, rgba16f) uniform writeonly image2D light;
layout(binding = 1, r16f) uniform writeonly image2D distances;

// Halfway between the second and the third of four in a row: the cubic through them.
vec4 halfway(vec4 a, vec4 b, vec4 c, vec4 d) { return 0.5625 * (b + c) - 0.0625 * (a + d); }

vec4 secondDifference(vec4 a, vec4 b, vec4 c, vec4 d) { return max(abs(a - 2.0 * b + c), abs(b - 2.0 * c + d)); }

float largest(vec4 v) { return max(max(v.x, v.y), max(v.z, v.w)); }

// The four rays around a cell and what lies around those, row by row.
struct Surroundings {
  vec4 rows[16];
};

Surroundings surroundingsOf(ivec2 cell) {
  ivec2 last = textureSize(coarseLight, 0) - 1;
  Surroundings around;
  for (int i = 0; i < 16; ++i) {
    around.rows[i] = texelFetch(coarseLight, clamp(cell + ivec2(i & 3, i >> 2) - 1, ivec2(0), last), 0);
  }
  return around;
}

// How much the rays around a cell bend. All three new rays of a cell are judged together: by what is beside each of them
// alone, an edge would be seen too late.
float curvatureOf(Surroundings s) {
  vec4 across = max(secondDifference(s.rows[4], s.rows[5], s.rows[6], s.rows[7]),
                    secondDifference(s.rows[8], s.rows[9], s.rows[10], s.rows[11]));
  vec4 up = max(secondDifference(s.rows[1], s.rows[5], s.rows[9], s.rows[13]),
                secondDifference(s.rows[2], s.rows[6], s.rows[10], s.rows[14]));
  return largest(across + up);
}

// Mean distance of what two rays see.
vec2 distanceAndOpacity(ivec2 texel, vec4 seen) {
  ivec2 last = textureSize(coarseLight, 0) - 1;
  float opacity = 1.0 - seen.w;
  return vec2(texelFetch(coarseDistances, min(texel, last), 0).x * opacity, opacity);
}

void keep(ivec2 texel, vec4 seen, vec2 distanceAndOpacity) {
  imageStore(light, texel, vec4(max(seen.xyz, vec3(0.0)), clamp(seen.w, 0.0, 1.0)));
  float mean = distanceAndOpacity.y > 0.0 ? distanceAndOpacity.x / distanceAndOpacity.y : kFarDistance;
  imageStore(distances, texel, vec4(mean));
}

// Whether the surfaces that the rays of a cell meet may make them differ: they are apart, and not all of them are behind
// the clouds or before them.
bool surfacesDiffer(ivec2 cell, Task task, Surroundings s, float farthestCloudM) {
  const int spacing = 2 * RAY_SPACING;
  ivec2 corner = cell * spacing;
  float nearestDepth = 0.0;
  float farthestDepth = 1.0;
  for (int i = 0; i < 9; ++i) {
    float depth = depthAt(corner + RAY_SPACING * ivec2(i % 3, i / 3));
    nearestDepth = max(nearestDepth, depth);
    farthestDepth = min(farthestDepth, depth);
  }
  vec3 ray = rayThrough(vec2(corner) + 0.5 + float(RAY_SPACING));
  float nearest = sceneDistance(nearestDepth, ray);
  float farthest = sceneDistance(farthestDepth, ray);
  bool isOpaque = s.rows[5].w + s.rows[6].w + s.rows[9].w + s.rows[10].w <= 0.0;
  bool isBehind = nearest >= task.end || (isOpaque && nearest > 1.5 * farthestCloudM);
  return !(farthest <= 1.1 * nearest || isBehind || farthest <= task.begin);
}

// Share of the light of a place that the air lets through.
float leftByAir(vec3 direction, float distanceM) {
#ifdef HAZE
  vec3 left = airTransmittance(direction.y * distanceM, distanceM);
  return max(max(left.x, left.y), left.z);
#else
  return 1.0;
#endif
}

// How many times the tolerances the rays around a cell may bend: more where all cloud that they see lies in the far field,
// and that the more, the less the air leaves of it.
float leniency(ivec2 cell, Task task, Surroundings s) {
  if (task.end <= clouds.farField.x) return 1.0;
  ivec2 last = textureSize(coarseDistances, 0) - 1;
  float nearest = kFarDistance;
  for (int i = 0; i < 16; ++i) {
    float distance = texelFetch(coarseDistances, clamp(cell + ivec2(i & 3, i >> 2) - 1, ivec2(0), last), 0).x;
    nearest = s.rows[i].w < 0.99 ? min(nearest, distance) : nearest;
  }
  float far = 1.0 - detailLeft(nearest);
  vec3 direction = normalize(rayThrough(vec2(cell * (2 * RAY_SPACING)) + 0.5));
  return mix(1.0, clouds.farField.z / leftByAir(direction, min(nearest, clouds.layer.z)), far);
}

// HISTORY: cells are listed that bend by this share of the tolerance. Where most rays need not be marched, so many more of them
// make the picture better than it is without.
#ifdef HISTORY
const float kListed = 0.25;
#else
const float kListed = 1.0;
#endif

// Fills a cell; whether its three new rays may be left at that, and if not, whether they may for want of anything better.
bool isFilled(ivec2 cell, Task task, out bool mayBeLeft) {
  Surroundings s = surroundingsOf(cell);
  vec2 a = distanceAndOpacity(cell, s.rows[5]);
  vec2 b = distanceAndOpacity(cell + ivec2(1, 0), s.rows[6]);
  vec2 c = distanceAndOpacity(cell + ivec2(0, 1), s.rows[9]);
  vec2 d = distanceAndOpacity(cell + ivec2(1, 1), s.rows[10]);
  ivec2 texel = 2 * cell;
  keep(texel, s.rows[5], a);
  vec4 low = halfway(s.rows[0], s.rows[1], s.rows[2], s.rows[3]);
  vec4 middle = halfway(s.rows[4], s.rows[5], s.rows[6], s.rows[7]);
  vec4 high = halfway(s.rows[8], s.rows[9], s.rows[10], s.rows[11]);
  vec4 highest = halfway(s.rows[12], s.rows[13], s.rows[14], s.rows[15]);
  keep(texel + ivec2(1, 0), middle, a + b);
  keep(texel + ivec2(0, 1), halfway(s.rows[1], s.rows[5], s.rows[9], s.rows[13]), a + c);
  keep(texel + ivec2(1, 1), halfway(low, middle, high, highest), a + b + c + d);
  float cloudM = max(max(a.x, b.x), max(c.x, d.x));  // of opaque rays
  float tolerance = (RAY_SPACING > 1 ? clouds.sight.y : clouds.sight.z) * leniency(cell, task, s);
  float curvature = curvatureOf(s);
  mayBeLeft = curvature <= tolerance && !surfacesDiffer(cell, task, s, cloudM);
  return mayBeLeft && curvature <= kListed * tolerance;
}

void refineTile(uint group, uint invocation) {
  const uint side = uint(TILE_SIDE / (2 * RAY_SPACING));
  uint index = (group * 64u + invocation) / (side * side);
  bool isListed = false;
  bool mayBeLeft = false;
  ivec2 cell = ivec2(0);
  if (index < tiles.groups.w) {
    Task task = tiles.tasks[index];
    cell = taskPlace(task) * int(side) + placeInSquare((group * 64u + invocation) % (side * side), side);
    isListed = all(lessThan(cell * 2, imageSize(light))) && !isFilled(cell, task, mayBeLeft);
  }
  uint first = placesInList(invocation, isListed ? 3u : 0u);
  if (!isListed) return;
  uint how = mayBeLeft ? kMayBeLeft : 0u;
  rays.texels[first] = packedPlace(2 * cell + ivec2(1, 0)) | how;
  rays.texels[first + 1u] = packedPlace(2 * cell + ivec2(0, 1)) | how;
  rays.texels[first + 2u] = packedPlace(2 * cell + ivec2(1, 1)) | how;
}
