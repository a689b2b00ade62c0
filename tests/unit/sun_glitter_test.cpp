// The glitter of sun and moon on water against Cox and Munk's statistics, integrated in double here: facets
// of Gaussian slopes, weighted by how much of each is seen from the eye and not hidden by waves (Smith 1967,
// with the error function), lit from all of the disc that is above the horizon, Fresnel's reflectance by
// Snell's angles.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

#include "skydrop/core/shared_glitter.h"
#include "support/margin.h"

namespace skydrop::core::shared {
namespace {

using Vec = glm::dvec3;

constexpr double kDegree = std::numbers::pi / 180, kRadius = 0.2666 * kDegree, kSlope = 0.14;

Vec towards(double elevation, double azimuth) {
  const double e = elevation * kDegree, a = azimuth * kDegree;
  return {std::cos(e) * std::cos(a), std::sin(e), std::cos(e) * std::sin(a)};
}

double fresnelBySnell(double incidence) {
  const double t = std::asin(std::sin(incidence) / 1.34), i = incidence;
  if (i < 1e-6) return 0.34 * 0.34 / (2.34 * 2.34);
  const double s = std::sin(i - t) / std::sin(i + t), p = std::tan(i - t) / std::tan(i + t);
  return (s * s + p * p) / 2;
}

double smithLambda(double elevation) {
  const double nu = std::tan(elevation) / (std::sqrt(2) * kSlope);
  return (std::exp(-nu * nu) / (nu * std::sqrt(std::numbers::pi)) - std::erfc(nu)) / 2;
}

// Radiance towards the eye per illuminance across the rays, of a light that is a point.
double fromPoint(const Vec& eye, const Vec& light) {
  const Vec normal = glm::normalize(eye + light);
  const double x = normal.x / normal.y, z = normal.z / normal.y;
  const double slopes =
      std::exp(-(x * x + z * z) / (2 * kSlope * kSlope)) / (2 * std::numbers::pi * kSlope * kSlope);
  // Facets of this slope per level area have the area 1 / normal.y; the solid angle of light that one slope
  // stands for is 4 cos(incidence) normal.y^3. What is seen of the level area is eye.y (1 + lambda of the
  // eye), and of it the light reaches (1 + lambda of the eye) / (1 + both).
  const double incidence = std::acos(std::min(glm::dot(normal, eye), 1.0));
  const double seenAndLit = 1 / (1 + smithLambda(std::asin(eye.y)) + smithLambda(std::asin(light.y)));
  return fresnelBySnell(incidence) * slopes * seenAndLit / (4 * eye.y * std::pow(normal.y, 4));
}

// The mean over the part of a disc that is above the horizon.
double fromDisc(const Vec& eye, double elevation) {
  constexpr int kRows = 60, kColumns = 12;
  double sum = 0, weight = 0;
  for (int i = 0; i < kRows; ++i) {
    const double v = -1 + (i + 0.5) * 2 / kRows, height = elevation * kDegree + v * kRadius;
    if (height <= 0) continue;
    const double half = std::sqrt(1 - v * v);
    for (int j = 0; j < kColumns; ++j) {
      const double u = half * (-1 + (j + 0.5) * 2 / kColumns);
      sum += half * fromPoint(eye, towards(height / kDegree, 180 + u * kRadius / kDegree));
      weight += half;
    }
  }
  return sum / weight;
}

double drawn(const Vec& eye, double elevation, const glm::dvec2& shown = {0, 0}, double hidden = kSlope) {
  return f64::sunGlitter(eye, towards(elevation, 180), kRadius, shown, hidden, kSlope);
}

TEST(SunGlitter, isThatOfCoxAndMunkAtEveryHeightOfTheSun) {
  // Root mean square error over eyes at elevations from 0.3 to 70 degrees and up to 20 degrees beside the
  // sun's azimuth, relative to the brightest: 1 %, and 3 % while the disc is cut by the horizon, where it
  // stands for its middle. The total light that is sent there: within 1 % and 4 %.
  for (const double elevation : {60.0, 30.0, 10.0, 3.0, 1.0, 0.1, 0.0, -0.1}) {
    double squares = 0, most = 0, sum = 0, exactSum = 0;
    int count = 0;
    for (const double seen : {0.3, 1.0, 2.0, 3.0, 5.0, 10.0, 20.0, 30.0, 45.0, 60.0, 70.0}) {
      for (const double aside : {0.0, 2.0, 5.0, 10.0, 20.0}) {
        const double exact = fromDisc(towards(seen, aside), elevation),
                     got = drawn(towards(seen, aside), elevation);
        squares += (got - exact) * (got - exact), most = std::max(most, exact);
        sum += got * std::sin(2 * seen * kDegree), exactSum += exact * std::sin(2 * seen * kDegree);
        ++count;
      }
    }
    const double error = std::sqrt(squares / count) / most;
    std::printf("sun at %5.1f degrees: root mean square %.4f, all light %+.4f\n", elevation, error,
                sum / exactSum - 1);
    EXPECT_LT(error, elevation < 1 ? 0.03 : 0.01) << elevation;
    EXPECT_NEAR(sum / exactSum, 1, elevation < 1 ? 0.04 : 0.01) << elevation;
  }
}

TEST(SunGlitter, wavesThatAreDrawnMakeTheSameMean) {
  // Slopes of drawn waves with 60 % of the variance, by their distribution: the mean is that of a sea without
  // any, within 1e-3 (the rule's own error).
  const double hidden = kSlope * std::sqrt(0.4), spread = kSlope * std::sqrt(0.6);
  for (const double elevation : {40.0, 10.0, 1.0}) {
    for (const double seen : {2.0, 10.0, 40.0}) {
      const Vec eye = towards(seen, 0.5);
      double sum = 0, weight = 0;
      for (double x = -5; x <= 5; x += 0.1) {
        for (double z = -5; z <= 5; z += 0.1) {
          const double share = std::exp(-(x * x + z * z) / 2);
          sum += share * drawn(eye, elevation, spread * glm::dvec2(x, z), hidden), weight += share;
        }
      }
      EXPECT_NEAR(sum / weight / drawn(eye, elevation), 1, 1e-3) << elevation << ' ' << seen;
    }
  }
}

TEST(SunGlitter, drawnAndHiddenWavesHaveTheSlopeOfAll) {
  // Slopes of drawn waves at 400 000 places, each size wholly drawn, half and not at all: with what is hidden
  // 1, within 1 %.
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const double swell : {0.0, 0.5, 1.0}) {
    for (const double ripple : {0.0, 1.0}) {
      const double wave = std::max(swell, ripple);
      double squares = 0;
      constexpr int kPlaces = 400'000;
      for (int i = 0; i < kPlaces; ++i) {
        const auto noise = [&](bool isTurned) {
          const f64::Uvec2 cell(random() % 100'000, random() % 100'000);
          const f64::Vec2 inside(unit(random), unit(random));
          return isTurned ? f64::turnedLatticeNoise(cell, inside).x : f64::latticeNoise(cell, inside).x;
        };
        const double slope = noise(false) * f64::kSwellShare * swell + noise(false) * f64::kWaveShare * wave +
                             noise(true) * f64::kRippleShare * ripple;
        squares += slope * slope;
      }
      const double hidden = f64::hiddenShare(swell, wave, ripple);
      EXPECT_NEAR(squares / kPlaces + hidden * hidden, 1, 0.01) << swell << ' ' << ripple;
    }
  }
}

TEST(SunGlitter, noMoreLightComesBackThanFell) {
  // All directions together: 2 to 3 % with a high sun (Fresnel's 2.1 % and a little for slopes), more the
  // lower it stands, never all of it.
  double last = 0;
  for (const double elevation : {60.0, 30.0, 10.0, 3.0}) {
    double flux = 0;
    constexpr double kStep = 0.5;
    for (double seen = kStep / 2; seen < 90; seen += kStep) {
      for (double around = kStep / 2; around < 180; around += kStep)
        flux += 2 * drawn(towards(seen, around), elevation) * std::sin(seen * kDegree) *
                std::cos(seen * kDegree) * std::pow(kStep * kDegree, 2);
    }
    const double share = flux / std::sin(elevation * kDegree);
    if (elevation == 60) {
      EXPECT_NEAR(share, 0.025, 0.005);
    }
    EXPECT_GT(share, last) << elevation;
    EXPECT_LT(share, 1) << elevation;
    last = share;
  }
}

TEST(SunGlitter, functionsOfWavesAndDiscAreThoseOfTheLiterature) {
  // Smith's function within 0.4 % of 1 + lambda; the middle of a cut disc within 1.4 % of its radius; Fresnel
  // within 1e-6.
  for (double elevation = 0.05; elevation < 89; elevation *= 1.3) {
    const double sine = std::sin(elevation * kDegree);
    const double exact = 1 + smithLambda(elevation * kDegree);
    EXPECT_NEAR((1 + f64::hiddenByWaves(sine, kSlope) / sine) / exact, 1, 0.004) << elevation;
    EXPECT_NEAR(f64::waterReflectance(sine), fresnelBySnell((90 - elevation) * kDegree), 1e-6) << elevation;
  }
  for (const double t : {-0.99, -0.8, -0.5, 0.0, 0.4, 0.9}) {
    double sum = 0, weight = 0;
    for (double v = -0.9995; v < 1; v += 0.001) {
      if (v + t <= 0) continue;
      sum += std::sqrt(1 - v * v) * (v + t), weight += std::sqrt(1 - v * v);
    }
    EXPECT_NEAR(f64::risenSine(t * kRadius, kRadius) / kRadius, sum / weight, 0.014) << t;
  }
}

TEST(Stability, S64_glitterIsFiniteForEyeAndLightOnTheHorizonInZenithAndNadir) {
  // In float: any of level, upright, grazing and opposite directions, calm and rough, hidden waves down to a
  // hundredth: finite, not negative; a sun that has set sends nothing; next to it nothing jumps.
  const glm::vec3 directions[] = {{1, 0, 0},  {-1, 0, 0},    {0, 1, 0},
                                  {0, -1, 0}, {1, 1e-7f, 0}, {-1, 1e-4f, 0}};
  for (const glm::vec3& eye : directions) {
    for (const glm::vec3& light : directions) {
      for (const float slope : {0.02f, 0.14f, 0.3f}) {
        const float glitter = f32::sunGlitter(eye, light, 0.00465f, {0.1f, 0}, 0.7f * slope, slope);
        EXPECT_TRUE(std::isfinite(glitter) && glitter >= 0) << eye.x << eye.y << ' ' << light.x << light.y;
      }
    }
  }
  const auto at = [](double elevation) {
    return static_cast<double>(f32::sunGlitter(glm::vec3(towards(3, 0)), glm::vec3(towards(elevation, 180)),
                                               0.00465f, {0, 0}, 0.14f, 0.14f));
  };
  EXPECT_TRUE(test::holds("S64", test::apart(at(-0.3), 0), test::atMost(1e-3 * at(1)), "light"));
  for (double elevation = -0.4; elevation < 1; elevation += 0.01)
    EXPECT_TRUE(test::holds("S64", test::apart(at(elevation + 0.01), at(elevation)),
                            test::atMost(0.02 * at(1)), "light"))
        << elevation;
}

}  // namespace
}  // namespace skydrop::core::shared
