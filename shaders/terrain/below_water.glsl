// The ground as it is seen through the sea's surface: rays bend there, and waves gather the sun's light. Included after
// terrain/land.glsl, with WATER_DETAIL alone.
#include "terrain/sea_waves.glsl"

const float kBentToM = 14.0;       // of depth: deeper ground is seen as if the surface were not there
const int kBendingWaves = 20;      // as many of the longest

struct SeenGround {
  vec3 place;    // relative to the eye
  float gather;  // of the sun's light
};

// Of the ground that a ray meets at `straight`. The sum of waves ends at the first where no pixel at hand shows shallow water.
SeenGround groundThroughWater(vec3 straight) {
  float depthM = -(straight.y + eyeFromBase.y);
  bool bends = depthM > 0.0 && depthM < kBentToM && eyeFromBase.y > 0.0;
  float dip = max(-straight.y, 1e-4);
  vec3 surface = straight * (eyeFromBase.y / dip);
  float distanceM = max(length(surface), 1e-3);
  SeaWaveSum waves = seaWavesAt(surface.xz, seaFootprintOf(surface), depthM,
                                bends ? min(seaCausticCount, kBendingWaves) : 0);
  vec3 ray = surface / distanceM;
  vec3 bent = intoWater(ray, normalize(vec3(waves.slope.x, 1.0, waves.slope.y)));
  float left = bends ? smoothstep(kBentToM, 0.5 * kBentToM, depthM) : 0.0;
  vec2 shift = bent.xz * (depthM / max(-bent.y, 0.3));
  SeenGround seen;
  vec2 level = mix(straight.xz, surface.xz + shift, left);
  seen.place = vec3(level.x, straight.y, level.y);
  seen.gather = mix(1.0, caustic(waves.curvature, seaWater.z * waves.left / max(waves.variance, 1e-9), depthM, seaWater.y),
                    left * saturate(distanceM > 0.0 ? 200.0 / distanceM : 1.0));
  return seen;
}

vec3 groundAsSeen(vec3 straight, ivec2 pixel) {
  SeenGround seen = groundThroughWater(straight);
  vec3 shares = lightSharesAt(pixel, straight);
  shares.x *= seen.gather;
  return endingLandThroughAir(landLight(seen.place, shares), straight, leftOfLight(straight));
}
