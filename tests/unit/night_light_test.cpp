#include "skydrop/sky/night_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

namespace skydrop::sky {
namespace {

TEST(NightLight, fiveMagnitudesAreAFactorOfAHundred) {
  EXPECT_NEAR(illuminanceOfMagnitude(1) / illuminanceOfMagnitude(6), 100, 1e-9);
  EXPECT_NEAR(illuminanceOfMagnitude(0) * 1e3, 2.56e-6, 0.01e-6) << "lux";
}

TEST(NightLight, starsGoFromBlueToRedAndSendTheirMagnitude) {
  // The ratio of blue to red falls with B-V; the luminance is 1 whatever the colour. The sun's B-V is the
  // white of 5800 K, a little warmer than sRGB's.
  double before = 1e9;
  for (double bv = -0.4; bv <= 2; bv += 0.1) {
    const glm::dvec3 color = starColor(bv);
    EXPECT_NEAR(glm::dot(color, glm::dvec3(0.2126, 0.7152, 0.0722)), 1, 1e-12);
    EXPECT_GE(color.z, 0);
    EXPECT_LT(color.z / color.x, before) << bv;
    before = color.z / color.x;
  }
  const glm::dvec3 sun = starColor(0.65);
  EXPECT_NEAR(sun.x, 1.1, 0.05);
  EXPECT_NEAR(sun.z, 0.9, 0.05);
}

TEST(NightLight, moonIsAQuarterOfALuxWhenFullAndATenthAtTheQuarter) {
  const double full = moonIlluminance(0, 384400);
  EXPECT_GT(full * 1e3, 0.25);
  EXPECT_LT(full * 1e3, 0.33);
  EXPECT_NEAR(moonIlluminance(90, 384400) / full, 0.091, 0.002);
  EXPECT_NEAR(moonIlluminance(0, 356500) / moonIlluminance(0, 406700), std::pow(406.7 / 356.5, 2), 1e-9);
  EXPECT_LT(moonIlluminance(180, 384400) / full, 1e-3);
}

// The light of the disc by Lommel and Seeliger's law, in units of its area: a sum over it.
double discShare(double phaseDegrees) {
  const double a = glm::radians(phaseDegrees);
  const glm::dvec3 toSun(std::sin(a), 0, std::cos(a));
  constexpr int kSide = 800;
  double sum = 0;
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      const double x = 2 * (column + 0.5) / kSide - 1, y = 2 * (row + 0.5) / kSide - 1;
      const double r2 = x * x + y * y;
      if (r2 >= 1) continue;
      const double seen = std::sqrt(1 - r2), lit = std::max(glm::dot(glm::dvec3(x, y, seen), toSun), 0.0);
      sum += 2 * lit / (lit + seen);
    }
  }
  return sum * 4 / (kSide * kSide) / std::numbers::pi;
}

TEST(NightLight, theDiscAsAWholeSendsItsIlluminance) {
  for (const double phase : {0.0, 10.0, 60.0, 90.0, 120.0, 150.0}) {
    EXPECT_NEAR(lommelSeeligerShare(phase), discShare(phase), 2e-3) << phase;
    const double sine = kMoonRadiusKm / 384400;
    const double solidAngle = 2 * std::numbers::pi * (1 - std::sqrt(1 - sine * sine));
    const double sent = moonRadiance(phase, 384400) * solidAngle * discShare(phase);
    EXPECT_NEAR(sent / moonIlluminance(phase, 384400), 1, 0.02) << phase;
  }
  EXPECT_EQ(lommelSeeligerShare(0), 1);
  EXPECT_EQ(lommelSeeligerShare(180), 0);
  for (const double phase : {0.0, 1e-12, 179.999, 180.0, -60.0})
    EXPECT_TRUE(std::isfinite(moonRadiance(phase, 4e5)));
}

}  // namespace
}  // namespace skydrop::sky
