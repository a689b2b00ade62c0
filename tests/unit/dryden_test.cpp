// Turbulence after Dryden: intensities and lengths by height, variance and spectrum of the gusts.
#include "skydrop/weather/dryden.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "skydrop/core/deterministic_math.h"
#include "skydrop/core/hash.h"

namespace skydrop::weather {
namespace {

constexpr double kPi = core::dmath::kPi;

TEST(Dryden, scalesNearTheGroundAreThoseOfTheSpecification) {
  // MIL-F-8785C, figures 10 and 11, at 200 feet with W20 = 30 knots: L_w = 200 ft, L_u = h / (.177 +
  // .000823 h)^1.2, sigma_w = .1 W20, sigma_u = sigma_w / (.177 + .000823 h)^.4.
  const double w20 = 30 * 0.514444;
  const DrydenScales s = drydenScales(200 * kFootM, w20, 3);
  EXPECT_NEAR(s.lengthM.z, 200 * kFootM, 1e-9);
  EXPECT_NEAR(s.lengthM.x, 200 / std::pow(0.3416, 1.2) * kFootM, 1e-9);
  EXPECT_NEAR(s.intensityMps.z, 0.1 * w20, 1e-12);
  EXPECT_NEAR(s.intensityMps.x, 0.1 * w20 / std::pow(0.3416, 0.4), 1e-9);
  EXPECT_EQ(s.intensityMps.x, s.intensityMps.y);
}

TEST(Dryden, scalesAreContinuousInHeight) {
  // At the borders at 10, 1000 and 2000 feet nothing jumps, and between the latter it is linear.
  for (const double feet : {10.0, 1000.0, 2000.0}) {
    const DrydenScales below = drydenScales(feet * kFootM * (1 - 1e-9), 12, 3);
    const DrydenScales above = drydenScales(feet * kFootM * (1 + 1e-9), 12, 3);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(below.intensityMps[i], above.intensityMps[i], 1e-6) << feet;
      EXPECT_NEAR(below.lengthM[i], above.lengthM[i], 1e-4) << feet;
    }
  }
  const DrydenScales middle = drydenScales(1500 * kFootM, 12, 3), high = drydenScales(2000 * kFootM, 12, 3);
  EXPECT_NEAR(middle.intensityMps.x, (1.2 + high.intensityMps.x) / 2, 1e-9);
  EXPECT_NEAR(middle.lengthM.x, 1375 * kFootM, 1e-9);
}

TEST(Dryden, intensityAloftIsThatOfTheFigure) {
  // Figure 7 at its points: light turbulence at 1750 ft 3.6 ft/s, moderate at 7500 ft 10.1, severe at 45000
  // ft 8.2.
  EXPECT_NEAR(exceededIntensity(1750 * kFootM, 1), 3.6 * kFootM, 1e-9);
  EXPECT_NEAR(exceededIntensity(7500 * kFootM, 3), 10.1 * kFootM, 1e-9);
  EXPECT_NEAR(exceededIntensity(45000 * kFootM, 4), 8.2 * kFootM, 1e-9);
  EXPECT_EQ(exceededIntensity(3000, 0), 0);
}

TEST(Dryden, noiseHasMean0AndVariance1) {
  double sum = 0, square = 0;
  constexpr int kCount = 1000000;
  for (std::uint64_t i = 0; i < kCount; ++i) {
    core::RandomStream random{7, i};
    const double n = whiteNoise(random.next());
    sum += n, square += n * n;
  }
  EXPECT_NEAR(sum / kCount, 0, 0.004);  // 4 standard errors
  EXPECT_NEAR(square / kCount, 1, 0.005);
}

}  // namespace
}  // namespace skydrop::weather
