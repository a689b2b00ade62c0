// The cloud in a cube that the laboratory takes light through: its density from two noises, the sum along a ray, and two
// ways to let the sun shine through it. Places in edges of the cube; densities are extinctions per edge but for a factor.
// Source: Thomann, "Procedural Cloud Shader", BFH 2020, section 6 (density of Perlin times Voronoi noise with thresholds
// and multipliers; sunlight by distance on the screen).
#ifndef __cplusplus
#include "shared/cloud_light.glsl"
#include "shared/lab/noise.glsl"
#endif

struct CubeCloud {
  Uint cells;  // lattice cells to an edge, of both noises
  Uint seed;
  Real perlinThreshold;
  Real perlinMultiplier;
  Real voronoiThreshold;
  Real voronoiMultiplier;
};

// Three octaves of Perlin noise in [0, 1], and Voronoi noise of two octaves, 1 at the seeds. The place is taken modulo 1.
FN Vec2 cubeNoises(CubeCloud cloud, Vec3 place) {
  Vec3 p = Vec3(fractionOf(place.x), fractionOf(place.y), fractionOf(place.z));
  Real perlin = perlinSpace(p, cloud.cells, cloud.seed) + Real(0.5) * perlinSpace(p, cloud.cells * Uint(2u), cloud.seed) +
                Real(0.25) * perlinSpace(p, cloud.cells * Uint(4u), cloud.seed);
  Real voronoi = Real(0.67) * worley3(p, cloud.cells, cloud.seed) +
                 Real(0.33) * worley3(p, cloud.cells * Uint(2u), cloud.seed);
  return Vec2(saturate(Real(0.5) + Real(0.55) * perlin), voronoi);
}

FN Real aboveThreshold(Real value, Real threshold, Real multiplier) {
  return max(value - threshold, Real(0.0)) * multiplier;
}

// x: of Perlin noise alone; y: of both, multiplied and doubled.
FN Vec2 cubeDensities(CubeCloud cloud, Vec2 noises) {
  Real perlin = aboveThreshold(noises.x, cloud.perlinThreshold, cloud.perlinMultiplier);
  Real voronoi = aboveThreshold(noises.y, cloud.voronoiThreshold, cloud.voronoiMultiplier);
  return Vec2(perlin, Real(2.0) * perlin * voronoi);
}

// Light along a ray, from its start on: what is left of what is behind, and what was turned into it.
struct CubeLight {
  Real transmittance;
  Real sun;  // in units of the sun's light times the phase function
  Real sky;  // in units of the light from all around
};

FN CubeLight make_cubeLight() {
  CubeLight light;
  light.transmittance = Real(1.0);
  light.sun = Real(0.0);
  light.sky = Real(0.0);
  return light;
}

// A step through an optical depth, to whose middle the sun's light has come through another.
FN CubeLight afterStep(CubeLight light, Real depth, Real sunDepth) {
  Real turned = light.transmittance * stepOpacity(depth);
  light.sun += turned * exp(-max(sunDepth, Real(0.0)));
  light.sky += turned;
  light.transmittance *= exp(-max(depth, Real(0.0)));
  return light;
}

// How much of the sun's light is added at a distance from it on the screen (in half heights): all of it up to 0.01, none
// from `reach` on; more strength reaches further. No account of what is between.
FN Real forwardedSun(Real distance, Real reach, Real strength) {
  Real t = saturate((distance - Real(0.01)) / max(reach - Real(0.01), Real(1e-6)));
  Real smooth_ = t * t * (Real(3.0) - Real(2.0) * t);
  return Real(1.0) - (smooth_ > Real(0.0) ? pow(smooth_, strength) : Real(0.0));
}

// The six skies of the source: how much is covered, how dense it is, where the sun is and what colour light has.
struct CubeMood {
  Real threshold;      // that both noises must exceed, added to the page's
  Real extinction;     // over the page's
  Real sunElevation;   // degrees
  Real sunStrength;
  Vec3 sunColor;
  Vec3 zenith;
  Vec3 horizon;
};

CONST int kDayMood = 0;
CONST int kPuffyMood = 1;
CONST int kNightMood = 2;
CONST int kSunsetMood = 3;
CONST int kClearMood = 4;
CONST int kStormyMood = 5;

FN CubeMood cubeMood(int which) {
  CubeMood mood;
  mood.threshold = Real(0.0);
  mood.extinction = Real(1.0);
  mood.sunElevation = Real(45.0);
  mood.sunStrength = Real(3.0);
  mood.sunColor = Vec3(Real(1.0), Real(0.95), Real(0.88));
  mood.zenith = Vec3(Real(0.08), Real(0.2), Real(0.5));
  mood.horizon = Vec3(Real(0.45), Real(0.6), Real(0.8));
  if (which == kPuffyMood) {
    mood.threshold = Real(0.03);
    mood.extinction = Real(2.5);
  } else if (which == kNightMood) {
    mood.sunElevation = Real(35.0);
    mood.sunStrength = Real(0.12);
    mood.sunColor = Vec3(Real(0.6), Real(0.75), Real(1.0));
    mood.zenith = Vec3(Real(0.002), Real(0.004), Real(0.012));
    mood.horizon = Vec3(Real(0.008), Real(0.012), Real(0.03));
  } else if (which == kSunsetMood) {
    mood.sunElevation = Real(6.0);
    mood.sunColor = Vec3(Real(1.0), Real(0.45), Real(0.15));
    mood.zenith = Vec3(Real(0.07), Real(0.1), Real(0.25));
    mood.horizon = Vec3(Real(0.8), Real(0.35), Real(0.12));
  } else if (which == kClearMood) {
    mood.threshold = Real(0.1);
    mood.extinction = Real(0.6);
  } else if (which == kStormyMood) {
    mood.threshold = Real(-0.12);
    mood.extinction = Real(3.0);
    mood.sunStrength = Real(1.2);
    mood.zenith = Vec3(Real(0.06), Real(0.08), Real(0.1));
    mood.horizon = Vec3(Real(0.2), Real(0.23), Real(0.25));
  }
  return mood;
}
