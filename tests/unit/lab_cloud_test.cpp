// The laboratory's clouds: sums that converge, light that is conserved.
#include <gtest/gtest.h>

#include <cmath>

#include "skydrop/lab/cloud_measure.h"
#include "skydrop/lab/shared.h"

namespace skydrop::lab {
namespace {

namespace f32 = core::shared::f32;
namespace f64 = core::shared::f64;

TEST(LabCloud, samplesConverge) {
  // Four times the samples leave less than a third of the error, down to a thousandth.
  double before = 1;
  for (const int steps : {5, 20, 80}) {
    const double error = sampleError({}, steps).meanError;
    EXPECT_LT(error, before / 3) << steps;
    before = error;
  }
  EXPECT_LT(before, 1e-3);
}

TEST(LabCloud, moreLightSamplesAreNearerToTheFinestMarch) {
  CloudKnobs knobs;
  knobs.steps = 8;
  const double one = lightError(knobs, 8, 1).meanError, four = lightError(knobs, 8, 4).meanError,
               sixteen = lightError(knobs, 8, 16).meanError;
  EXPECT_LT(four, one / 2);
  EXPECT_LT(sixteen, four / 2);
}

TEST(LabCloud, aStepNeitherMakesNorLosesLight) {
  // Through an even medium what is turned and what is left add up to 1, for any number of steps: within the
  // 5e-6 of stepOpacity.
  for (const double depth : {1e-6, 0.1, 1.0, 30.0, 1e6}) {
    for (const int steps : {1, 7, 100}) {
      f64::CubeLight light = f64::make_cubeLight();
      for (int i = 0; i < steps; ++i) light = f64::afterStep(light, depth / steps, 0);
      EXPECT_NEAR(light.sky + light.transmittance, 1, 5e-6) << depth << ' ' << steps;
      EXPECT_NEAR(light.transmittance, std::exp(-depth), 1e-12);
      EXPECT_EQ(light.sun, light.sky);
    }
  }
  const f64::CubeLight dark = f64::afterStep(f64::make_cubeLight(), 0.5, 1e9);
  EXPECT_EQ(dark.sun, 0);
}

TEST(LabCloud, forwardedSunIgnoresTheCloudUntilItIsMended) {
  CloudKnobs knobs;
  knobs.extinction = 60;
  const ForwardError error = forwardError(knobs);
  EXPECT_GT(error.plain, 0.1);
  EXPECT_LT(error.mended, 0.01);
  EXPECT_EQ(f64::forwardedSun(0.005, 0.7, 0.6), 1);
  EXPECT_EQ(f64::forwardedSun(0.7, 0.7, 0.6), 0);
  EXPECT_EQ(f64::forwardedSun(3, 0.7, 0.6), 0);
  EXPECT_TRUE(std::isfinite(f32::forwardedSun(0.01f, 0, 0)));
}

TEST(LabCloud, densityTilesAndIsTheProductOfBothNoises) {
  const f64::CubeCloud cloud{4, 3, 0.5, 2, 0.55, 3};
  for (int i = 0; i < 50; ++i) {
    // Eighths of a period and less: sums with whole numbers are exact.
    const glm::dvec3 place(i / 64.0, (i * 7 % 64) / 64.0, (i * 13 % 64) / 64.0);
    for (const glm::dvec3& way : {glm::dvec3(1, 0, 0), glm::dvec3(-2, 5, 0), glm::dvec3(0, 0, -1)})
      EXPECT_EQ(f64::cubeNoises(cloud, place), f64::cubeNoises(cloud, place + way));
    const glm::dvec2 densities = f64::cubeDensities(cloud, f64::cubeNoises(cloud, place));
    EXPECT_GE(densities.x, 0);
    EXPECT_GE(densities.y, 0);
    if (densities.x == 0) {
      EXPECT_EQ(densities.y, 0);
    }
  }
  EXPECT_EQ(f64::cubeDensities(cloud, {0.75, 0.8}), glm::dvec2(0.5, 2 * 0.5 * (0.8 - 0.55) * 3));
  const Volume volume = cloudVolume({});
  EXPECT_EQ(volume.pairs.size(), std::size_t{2} * kCloudVolumeSide * kCloudVolumeSide * kCloudVolumeSide);
}

}  // namespace
}  // namespace skydrop::lab
