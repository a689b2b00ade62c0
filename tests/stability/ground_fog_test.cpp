// Ground fog's closed form against quadrature in double.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "skydrop/core/shared.h"
#include "support/margin.h"

namespace skydrop::core::shared {
namespace {

// Simpson's rule on a stretch on which the height is all above the base or all below it.
double quadrature(double from, double rise, double length, double scaleHeight) {
  const auto density = [&](double t) { return std::exp(-std::max(from + rise * t, 0.0) / scaleHeight); };
  const int parts = 2 * static_cast<int>(std::ceil(20 * std::abs(rise) / scaleHeight) + 10);
  double sum = density(0) + density(1);
  for (int i = 1; i < parts; ++i) sum += (i % 2 ? 4 : 2) * density(static_cast<double>(i) / parts);
  return length * sum / (3 * parts);
}

double referencePath(double from, double rise, double length, double scaleHeight) {
  const double crossing = rise == 0 ? 0 : -from / rise;
  if (crossing <= 0 || crossing >= 1) return quadrature(from, rise, length, scaleHeight);
  return quadrature(from, rise * crossing, length * crossing, scaleHeight) +
         quadrature(0, rise * (1 - crossing), length * (1 - crossing), scaleHeight);
}

float pathInFloat(double from, double rise, double length, double scaleHeight) {
  return f32::groundFogPath(static_cast<float>(from), static_cast<float>(rise), static_cast<float>(length),
                            static_cast<float>(scaleHeight));
}

TEST(GroundFog, pathIsTheIntegralOfItsDensity) {
  // From below, at and above the base, up, down and level, for flat and deep fog: 1e-6 of the path (the
  // series of oneMinusExpOverX leaves 2e-7, Simpson's rule 1e-7).
  for (const double scaleHeight : {5.0, 40.0, 2000.0}) {
    for (const double from : {-800.0, -3.0, 0.0, 2.0, 60.0, 700.0}) {
      for (const double rise : {-1500.0, -60.0, -1e-3, 0.0, 1e-3, 3.0, 60.0, 1500.0}) {
        for (const double slant : {1.0, 30.0}) {
          const double length = std::max(std::abs(rise), 1.0) * slant;
          const double exact = referencePath(from, rise, length, scaleHeight);
          EXPECT_NEAR(f64::groundFogPath(from, rise, length, scaleHeight), exact, 1e-6 * exact + 1e-300)
              << scaleHeight << ' ' << from << ' ' << rise;
        }
      }
    }
  }
}

TEST(Stability, C32_groundFogHoldsForLevelAndEndlessRaysAndFromAnyHeight) {
  // In float, down to the ground from 0.1 to 1e6 m: opacity within 1e-5, and what two roundings of the eye's
  // height are worth (0.12 m at 1e6 m).
  constexpr double kDensity = 0.01;
  const auto opacity = [](double path) { return -std::expm1(-kDensity * path); };
  for (const double scaleHeight : {10.0, 40.0, 400.0}) {
    for (const double eye : {0.1, 10.0, 1000.0, 1e5, 1e6}) {
      for (const double slope : {-1.0, -0.3, -0.01}) {
        const double ground = -25, length = (ground - eye) / slope;
        const double exact = opacity(f64::groundFogPath(eye, ground - eye, length, scaleHeight));
        const float path = pathInFloat(eye, ground - eye, length, scaleHeight);
        const double rounding = 2 * eye * 0x1p-24 / scaleHeight + std::abs(eye) * 0x1p-24 / -slope * kDensity;
        EXPECT_TRUE(test::holds("C32",
                                test::apart(static_cast<double>(f32::groundFogOpacity(0.01f * path)), exact),
                                test::atMost(1e-5 + rounding), "opacity"))
            << scaleHeight << ' ' << eye << ' ' << slope;
      }
    }
  }
  // Level: the same from either side, within 1e-5 of the path, down to rises that are no normal floats.
  EXPECT_TRUE(test::holdsLive("C32"));
  // Endless: upwards H / slope of what is at the eye, and the way up to the base where that lies above;
  // level and downwards opaque; finite from anywhere.
  const double endless = static_cast<double>(f32::kFarMarker);
  for (const double slope : {1.0, 0.1, 1e-4, 1e-7}) {
    const auto up = [&](double from) {
      return static_cast<double>(pathInFloat(from, slope * endless, endless, 40)) * slope;
    };
    EXPECT_TRUE(test::holds("C32", test::apart(up(0) / 40, 1), test::atMost(1e-5), "relative")) << slope;
    EXPECT_TRUE(
        test::holds("C32", test::apart(up(80) / (40 * std::exp(-2)), 1), test::atMost(1e-5), "relative"))
        << slope;
    EXPECT_TRUE(test::holds("C32", test::apart(up(-500) / 540, 1), test::atMost(1e-5), "relative")) << slope;
    EXPECT_EQ(up(1e6), 0) << slope;
    EXPECT_EQ(f32::groundFogOpacity(0.01f * pathInFloat(1e6, -slope * endless, endless, 40)), 1) << slope;
  }
  EXPECT_EQ(f32::groundFogOpacity(0.2f * pathInFloat(-5, 0, endless, 40)), 1);
  EXPECT_EQ(f32::groundFogOpacity(0.2f * pathInFloat(1e6, 0, endless, 40)), 0);
  EXPECT_EQ(f32::groundFogOpacity(0), 0);
}

TEST(GroundFog, thinFogIsNotRoundedAway) {
  // An optical depth of 1e-9 is an opacity of 1e-9, within 1e-6 of it, where 1 - exp would be 0.
  EXPECT_NEAR(static_cast<double>(f32::groundFogOpacity(1e-9f)) / 1e-9, 1, 1e-6);
}

TEST(GroundFog, distanceIsWhereTheOpticalDepthIsReached) {
  // Down from above the fog and level: the path of that length has that optical depth, within 2e-4 (the
  // square of exp(-8) that the formula leaves out), as long as it ends above the base. Upwards it is at most
  // as far, and at least 0.7 of it for half of all fog.
  constexpr double kDensity = 0.02, kScale = 50;
  int tried = 0;
  for (const double from : {0.0, 20.0, 100.0, 400.0}) {
    for (const double slope : {-1.0, -0.2, -1e-3, 0.0}) {
      for (const double depth : {0.01, 0.3, 1.0}) {
        const double distance = f64::groundFogDistance(from, slope, depth, kDensity, kScale);
        if (from + slope * distance < 0) continue;
        ++tried;
        EXPECT_NEAR(kDensity * f64::groundFogPath(from, slope * distance, distance, kScale) / depth, 1, 2e-4)
            << from << ' ' << slope << ' ' << depth;
      }
    }
    const double all = kDensity * kScale * std::exp(-from / kScale) / 0.2;
    const double distance = f64::groundFogDistance(from, 0.2, all / 2, kDensity, kScale);
    const double reached = kDensity * f64::groundFogPath(from, 0.2 * distance, distance, kScale);
    EXPECT_LE(reached, all / 2);
    EXPECT_GE(reached, 0.7 * all / 2);
  }
  EXPECT_GT(tried, 25);
}

TEST(GroundFog, distanceIsFiniteFromAnywhere) {
  // In float, from -1e6 to 1e6 m, any slope, thin and dense: finite, not negative; from 1e6 m straight down
  // nearly all of the way.
  for (const float from : {-1e6f, -10.0f, 0.0f, 100.0f, 1e4f, 1e6f}) {
    for (const float slope : {-1.0f, -1e-3f, -1e-9f, 0.0f, 1e-9f, 1e-3f, 1.0f}) {
      for (const float extinction : {1e-6f, 0.2f}) {
        for (const float scaleHeight : {5.0f, 2000.0f}) {
          const float distance = f32::groundFogDistance(from, slope, 1e-6f, extinction, scaleHeight);
          EXPECT_TRUE(distance >= 0 && std::isfinite(distance)) << from << ' ' << slope << ' ' << distance;
        }
      }
    }
  }
  EXPECT_NEAR(static_cast<double>(f32::groundFogDistance(1e6f, -1, 1, 0.01f, 40)), 1e6, 200);
  // Nearly level, in float as on a level ray: 50 m at 0.02 / m.
  EXPECT_NEAR(static_cast<double>(f32::groundFogDistance(0, -1e-6f, 1, 0.02f, 50)), 50, 0.01);
}

}  // namespace
}  // namespace skydrop::core::shared
