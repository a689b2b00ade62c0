// A picture of a volume of noise as clouds in a cube, seen from the side without perspective: absorption along the
// ray, and light from above by the density a little further up. Colour with its share of the pixel as alpha.
layout(binding = 0) uniform sampler3D noiseVolume;
layout(binding = 0, rgba8) writeonly uniform image2D picture;

uniform mat3 viewToVolume;
uniform float threshold;   // density is what lies above it
uniform float extinction;  // of a density of 1, to an edge of the cube
uniform int steps;

const float kReach = 0.9;        // half a picture, in edges: a turned cube's diagonal fits
const float kShadowWay = 0.08;   // edges
const vec3 kLight = vec3(1.0, 0.98, 0.95);
const vec3 kShade = vec3(0.45, 0.5, 0.6);

float densityAt(vec3 place) {
  return max(textureLod(noiseVolume, place + 0.5, 0.0).r - threshold, 0.0) / (1.0 - threshold);
}

// Where a ray enters and leaves the cube around the origin whose edges are 1; empty when x >= y.
vec2 wayThroughCube(vec3 origin, vec3 direction) {
  vec3 safe = mix(direction, vec3(1e-6), lessThan(abs(direction), vec3(1e-6)));
  vec3 a = (-0.5 - origin) / safe;
  vec3 b = (0.5 - origin) / safe;
  vec3 first = min(a, b);
  vec3 last = max(a, b);
  return vec2(max(max(first.x, first.y), first.z), min(min(last.x, last.y), last.z));
}

vec4 seenAlong(vec3 origin, vec3 direction, vec3 up) {
  vec2 way = wayThroughCube(origin, direction);
  if (way.x >= way.y) return vec4(0.0);
  float stepLength = (way.y - way.x) / float(steps);
  float transmittance = 1.0;
  vec3 light = vec3(0.0);
  for (int i = 0; i < steps; ++i) {
    vec3 place = origin + direction * (way.x + (float(i) + 0.5) * stepLength);
    float opacity = 1.0 - exp(-extinction * densityAt(place) * stepLength);
    float above = exp(-extinction * densityAt(place + up * kShadowWay) * kShadowWay);
    light += transmittance * opacity * mix(kShade, kLight, above);
    transmittance *= 1.0 - opacity;
  }
  float alpha = 1.0 - transmittance;
  // Straight alpha; the cube itself dims what is behind it, so that it can be seen.
  vec3 color = alpha > 0.0 ? light / alpha : vec3(0.0);
  return vec4(color * alpha / max(alpha + 0.12 * (1.0 - alpha), 1e-6), alpha + 0.12 * (1.0 - alpha));
}

void drawPixel(ivec2 pixel) {
  ivec2 size = imageSize(picture);
  if (any(greaterThanEqual(pixel, size))) return;
  vec2 place = kReach * (2.0 * (vec2(pixel) + 0.5) / vec2(size) - 1.0);
  vec3 origin = viewToVolume * vec3(place, 2.0);
  imageStore(picture, pixel, seenAlong(origin, viewToVolume * vec3(0.0, 0.0, -1.0), viewToVolume * vec3(0.0, 1.0, 0.0)));
}
