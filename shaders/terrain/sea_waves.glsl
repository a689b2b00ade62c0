// Waves of the sea near the eye (render::SeaWaves); programs are compiled with WATER_DETAIL in frames that have some.
#include "shared/sea_waves.glsl"

uniform vec4 seaWays[64];    // turns a metre along x and z, phase at the eye (turns), amplitude of the slope
uniform vec4 seaShapes[64];  // length (m), amplitude of breaking, 2 pi over the length
uniform int seaWaveCount;
uniform int seaCausticCount;  // of the first that gather light on the ground
uniform vec4 seaState;        // slope of all waves, threshold of whitecaps, turns of the surf, how much foam
uniform vec4 seaWater;        // turbidity, caustics, variance of the curvature (1/m^2)

// The first `most` waves at a place relative to the eye. A wave that no pixel at hand shows ends the sum: the rest is
// shorter (a software renderer runs both sides of a branch, but leaves loops).
SeaWaveSum seaWavesAt(vec2 relative, SeaFootprint footprint, float depthM, int most) {
  SeaWaveSum sum = noSeaWaves();
  for (int i = 0; i < most; ++i) {
    if (footprint.across2 > 0.25 * seaShapes[i].x * seaShapes[i].x) break;
    sum = withWave(sum, seaWays[i], seaShapes[i], relative, footprint, depthM);
  }
  return sum;
}

// Crests of a few waves are too straight and even: they are bent and grouped by noise of 20 m and of 200, without a change
// of their mean square.
struct SeaGroups {
  vec2 bend;    // of the place, m
  float share;  // of the slope
};

SeaGroups seaGroupsAt(vec2 place) {
  vec2 noise = noiseAt(place, 48), wide = turnedNoiseAt(place, 1);
  return SeaGroups(noise * 3.2 + wide * 26.0, clamp(1.0 + 1.1 * noise.y + 0.7 * wide.y, 0.3, 1.9) * 0.935);
}

SeaFootprint seaFootprintOf(vec3 relative) {
  float distanceM = length(relative);
  return seaFootprint(relative.xz, distanceM, -relative.y / distanceM, frame.depthToSea.w);
}
