// Splashes of rain on the sea (render::SplashPass): a ring on the water that widens, and water that leaps in its middle.
#include "frame.glsl"
#include "shared/hash.glsl"

uniform ivec3 firstSplash;  // numbers of the first cell (x, z) and of the span of time
uniform vec4 splashCells;   // its corner from the eye (x, z; m), side of a cell (m), cells along a side
uniform vec4 splashRain;    // share of cells with a splash, share of the span that is over, range (m)
uniform vec4 splashLight;   // rgb: radiance

const float kRingM = 0.2;    // of the widest ring
const float kLeastRing = 1.2; // pixels

struct Splash {
  vec4 position;
  vec2 aside;    // in radii of the widest ring
  vec3 stage;    // radius of the ring, its width (both in those), opacity
};

Splash splashCorner(int vertex) {
  int number = vertex / 6, corner = vertex % 6, side = int(splashCells.w);
  ivec2 cell = ivec2(number % side, number / side);
  uvec2 own = hash2(uvec2(firstSplash.xy + cell));
  float age = splashRain.y + unitOf(own.x);  // spans; each cell has its own beginning
  uvec3 bits = hash3(uvec3(own, uint(firstSplash.z + (age >= 1.0 ? 1 : 0))));
  age -= floor(age);
  vec2 middle = splashCells.xy + (vec2(cell) + vec2(unitOf(bits.x), unitOf(bits.y))) * splashCells.z;
  vec3 place = vec3(middle.x, 0.01 - frame.eye.x, middle.y);
  float distanceM = length(place);
  float pixelM = distanceM * frame.depthToSea.w;
  float radiusM = max(kRingM, kLeastRing * pixelM);
  vec2 aside = vec2(corner == 1 || corner == 3 || corner == 5 ? 1.0 : -1.0, corner == 2 || corner > 3 ? 1.0 : -1.0);
  vec4 clip = frame.viewProjection * vec4(place + vec3(aside.x, 0.0, aside.y) * radiusM, 1.0);
  bool isSeen = unitOf(bits.z) < splashRain.x && distanceM < splashRain.z && clip.w > frame.eye.y;
  Splash splash;
  splash.aside = aside;
  float thin = kRingM / radiusM;
  splash.stage = vec3(0.15 + 0.75 * age, max(0.16, pixelM / radiusM), 0.8 * (1.0 - age) * thin * thin *
                      smoothstep(1.0, 0.5, distanceM / splashRain.z));
  splash.position = isSeen ? vec4(clip.xy, 0.5 * clip.w, clip.w) : vec4(2.0, 2.0, 0.5, 1.0);
  return splash;
}

float splashOpacity(vec2 aside, vec3 stage) {
  float radius = length(aside);
  float ring = saturate(1.0 - abs(radius - stage.x) / stage.y);
  float leap = saturate(1.0 - radius / 0.3) * saturate(1.0 - 2.5 * stage.x);
  return (0.6 * ring + leap) * stage.z;
}
