// The cloud dome on the processor: its mesh, its curve, and where noise lies on it.
#include "skydrop/render/clouds/cloud_dome.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "skydrop/core/shared.h"
#include "skydrop/render/clouds/cloud_dome_mesh.h"
#include "skydrop/render/clouds/sheet_noise.h"

namespace skydrop::render {
namespace {

namespace f32 = core::shared::f32;
namespace f64 = core::shared::f64;

TEST(CloudDomeMesh, hasSevenLevelsOfTwentySegmentsWithTheirAlphas) {
  // Elevations 0, 4, 9 and 14 degrees with alpha 0, .3, .7 and 1, then evenly to the zenith with 1; all
  // vertices on the unit sphere.
  const CloudDomeMesh mesh = makeCloudDomeMesh();
  ASSERT_EQ(mesh.vertices.size(), 140u);
  ASSERT_EQ(mesh.indices.size(), 6u * 20 * 6);
  const double elevations[] = {0, 4, 9, 14, 39 + 1.0 / 3, 64 + 2.0 / 3, 90};
  const float alphas[] = {0, 0.3f, 0.7f, 1, 1, 1, 1};
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const CloudDomeVertex& vertex = mesh.vertices[i];
    EXPECT_NEAR(std::asin(std::min(vertex.direction.y, 1.0f)) * 180 / std::numbers::pi, elevations[i / 20],
                0.03);
    EXPECT_EQ(vertex.alpha, alphas[i / 20]);
    EXPECT_NEAR(glm::length(vertex.direction), 1, 1e-6);
  }
}

TEST(CloudDome, opacityIsTheBiasedExponentialAboveTheCutoff) {
  // bias (1 - exponent^(255 (n - cutoff))), 0 up to the cutoff: the source counts in the same steps of eight
  // bits for planes, and in whole units in its shader for the dome, where its exponent is this one to the
  // 255th power. Within 1e-6.
  for (const double exponent : {0.9, 0.96, 0.99}) {
    const double ofShader = std::pow(exponent, 255);
    for (double n = 0; n <= 1; n += 0.01) {
      const double exact = n < 0.61 ? 0 : 0.8 * (1 - std::pow(ofShader, n - 0.61));
      EXPECT_NEAR(0.8 * f64::sheetOpacity(n, 0.61, f64::sheetDepthPerNoise(exponent)), exact, 1e-6) << n;
    }
  }
}

TEST(CloudDome, levelSheetIsSeenAtItsHeightAndTheHemisphereAsItIs) {
  // Flatness 0: the direction itself. Flatness 1: overhead at height 1, and farther out the lower one looks,
  // never infinitely far.
  EXPECT_EQ(f64::domePlace({0.6, 0.8, 0}, 0), glm::dvec3(0.6, 0.8, 0));
  EXPECT_NEAR(f64::domePlace({0, 1, 0}, 1).y, 1, 1e-12);
  double before = 0;
  for (double elevation = 89; elevation >= 0; --elevation) {
    const double angle = elevation * std::numbers::pi / 180;
    const double out = f64::domePlace({std::cos(angle), std::sin(angle), 0}, 1).x;
    EXPECT_GT(out, before);
    before = out;
  }
  EXPECT_LT(before, 10);
}

TEST(CloudDome, aSkyIsNarrowerThanItsNoiseRepeats) {
  // Noise looks the same again where turned coordinates differ by nearly whole numbers in all three axes:
  // within 0.06 of a copy, a third of a cell of the first octave. The shortest such way along the sheet is
  // longer than the whole sky down to 14 degrees at the default scale, and than a view of 60 degrees straight
  // up at the largest of the slider.
  const f64::Vec3 normal = f64::domeTurn({0, 1, 0});
  EXPECT_NEAR(glm::length(normal), 1, 1e-6);
  EXPECT_NEAR(glm::dot(normal, f64::domeTurn({1, 0, 0})), 0, 1e-6);
  EXPECT_NEAR(glm::dot(f64::domeTurn({0, 0, 1}), f64::domeTurn({1, 0, 0})), 0, 1e-6);
  double shortest = 100;
  for (int x = -6; x <= 6; ++x) {
    for (int y = -6; y <= 6; ++y) {
      for (int z = -6; z <= 6; ++z) {
        const glm::dvec3 copies(x, y, z);
        if (copies != glm::dvec3(0) && std::abs(glm::dot(normal, copies)) < 0.06)
          shortest = std::min(shortest, glm::length(copies));
      }
    }
  }
  const auto radiusAt = [](double elevationDeg) {
    const double angle = elevationDeg * std::numbers::pi / 180;
    return f64::domePlace({std::cos(angle), std::sin(angle), 0}, 1).x;
  };
  EXPECT_GT(shortest, 2 * radiusAt(14) * clouds::CloudDomeSettings().scale);
  EXPECT_GT(shortest, 2 * radiusAt(60) * 0.8);
}

TEST(CloudDome, driftIsExactAfterMonths) {
  // The offset stays in [0, 1), goes with the time, and has no rounding of its own after 1e8 s: within 1e-7
  // of a copy.
  clouds::CloudDomeSettings settings;
  settings.speedX = 0.125;
  settings.speedY = -0.25;
  EXPECT_EQ(domeOffset(settings, 3), glm::dvec3(0.375, 0.25, 0));
  EXPECT_NEAR(domeOffset(settings, 1e8 + 3).x, 0.375, 1e-7);
  EXPECT_NEAR(domeOffset(settings, -3).x, 0.625, 1e-12);
  settings.speedX = settings.speedY = 0;
  EXPECT_EQ(domeOffset(settings, 1e8), glm::dvec3(0));
}

}  // namespace
}  // namespace skydrop::render
