// A layer of clouds is a shell that falls away from the eye: the bent rays of shaders/shared/cloud_light.glsl
// against the earth's sphere in doubles, and the reference march through them. C33, C34.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "skydrop/clouds/reference_march.h"
#include "skydrop/core/hash.h"
#include "skydrop/core/shared.h"
#include "support/margin.h"

namespace skydrop::clouds {
namespace {

namespace f32 = core::shared::f32;
namespace f64 = core::shared::f64;

constexpr double kMostDistanceM = 60000;

glm::dvec3 directionOf(double sine, double azimuth) {
  const double level = std::sqrt(1 - sine * sine);
  return {level * std::cos(azimuth), sine, level * std::sin(azimuth)};
}

TEST(Stability, C33_aBentRayIsAsHighOverTheSphereAsAStraightOne) {
  // From 0 to 10 km, all directions up to 60 km: what is left of the series is at most 1.5 m. Floats give
  // what doubles give within 1/128 m, half a unit in the last place of 60 km.
  EXPECT_TRUE(test::holdsLive("C33"));
  EXPECT_GT(stability::liveChecksOf("C33").front().measure(), 0.1)
      << "the series has no rest: compared with itself";
}

// How far a root in floats is from the level, as a share of the numbers that it was made of.
double residualOf(float above, float directionY, float bend, float root) {
  const double t = root;
  const double height = above + directionY * t + bend * t * t;
  return std::abs(height) / (std::abs(above) + std::abs(directionY * t) + bend * t * t);
}

TEST(Stability, C33_whereARayCrossesALevelIsNoDifferenceOfEqualNumbers) {
  // A million rays in floats: level within 1e-9, steep, up and down, from a millimetre to 30 km above or
  // below the level, and straight up. Both crossings lie on the level within 4e-7 of what they are made of;
  // they exist where doubles say so (but for rays that touch within rounding), and a ray that stays under has
  // no end. As minus b plus root over 2 a the nearer crossing is off by all of itself for a steep ray.
  core::RandomStream random{7, 0};
  double worst = 0;
  int crossing = 0, missing = 0;
  for (int i = 0; i < 1000000; ++i) {
    const auto sign = [&] { return random.nextUnit() < 0.5 ? -1.0 : 1.0; };
    const auto above = static_cast<float>(sign() * std::pow(10, 7.5 * random.nextUnit() - 3));
    const auto sine = static_cast<float>(sign() * std::pow(10, -9 * random.nextUnit()));
    const glm::dvec3 direction = directionOf(sine, 2 * std::numbers::pi * random.nextUnit());
    const auto bend = static_cast<float>(f64::rayBend(direction));
    const f32::RaySpan under = f32::bentRayUnder(above, sine, bend);
    const double square = static_cast<double>(sine) * sine - 4.0 * bend * above;
    const double rounding = 1e-6 * (static_cast<double>(sine) * sine + 4.0 * bend * std::abs(above));
    if (square < -rounding) {
      ASSERT_GT(under.begin, under.end);
      ++missing;
    }
    if (square <= rounding) continue;
    ++crossing;
    ASSERT_LT(under.begin, under.end);
    for (const float root : {under.begin, under.end})
      if (std::abs(root) < 1e12f) worst = std::max(worst, residualOf(above, sine, bend, root));
    ASSERT_TRUE(above > 0 || (under.begin <= 0 && under.end >= 0));
  }
  RecordProperty("worstResidual", std::to_string(worst * 1e9) + "e-9");
  EXPECT_TRUE(test::holds("C33", worst, test::below(4e-7), "relative"));
  EXPECT_TRUE(crossing > 500000 && missing > 10000) << crossing << ' ' << missing;
  // Without bend and without rise: under the level for ever, or never.
  const f32::RaySpan always = f32::bentRayUnder(-1, 0, 0), never = f32::bentRayUnder(1, 0, 0);
  EXPECT_TRUE(always.begin < -1e29f && always.end > 1e29f);
  EXPECT_GT(never.begin, never.end);
}

// The part of a ray within a layer, by walking along it.
f64::RaySpan walked(double eyeM, double baseM, double topM, const glm::dvec3& direction) {
  f64::RaySpan span = f64::make_raySpan(1e30, 0);
  const double bend = f64::rayBend(direction);
  for (double t = 0; t <= kMostDistanceM; t += 5) {
    const double height = eyeM + f64::placeOnBentRay(direction, bend, t).y;
    if (height <= baseM || height >= topM) continue;
    span.begin = std::min(span.begin, t);
    span.end = t;
  }
  return span;
}

TEST(Stability, C34_raysThatGrazeTheLayerLoseNothingOfIt) {
  // From below, within and above, every thousandth of a degree around the horizon: the span in floats holds
  // all that a walk in steps of 5 m finds within the layer, and no more than that by a step on either side.
  // Rays from just above the base leave it and enter it again (both parts count as one); from 282 m and less
  // above the top some touch it only in the distance.
  const double baseM = 1500, topM = 2500;
  int dipping = 0, found = 0, none = 0;
  for (const double eyeM :
       {1100.0, 1300.0, 1499.0, 1500.0, 1501.0, 1600.0, 1781.0, 2499.0, 2501.0, 2700.0, 2790.0, 9000.0}) {
    for (double degrees = -1.2; degrees <= 0.6; degrees += 0.009) {
      const glm::dvec3 direction = directionOf(std::sin(degrees * std::numbers::pi / 180), 1.1);
      const f32::Vec3 inFloat(direction);
      const float bend = f32::rayBend(inFloat);
      const auto above = [&](double level) { return static_cast<float>(eyeM - level); };
      const f32::RaySpan layer = f32::bentRayInLayer(f32::bentRayUnder(above(topM), inFloat.y, bend),
                                                     f32::bentRayUnder(above(baseM), inFloat.y, bend),
                                                     static_cast<float>(kMostDistanceM));
      const f64::RaySpan exact = walked(eyeM, baseM, topM, direction);
      SCOPED_TRACE(std::to_string(eyeM) + " m, " + std::to_string(degrees) + " degrees");
      if (exact.end <= exact.begin) {
        EXPECT_LE(layer.end - layer.begin, 30);  // a ray that only touches
        ++none;
        continue;
      }
      ++found;
      EXPECT_LE(layer.begin, exact.begin + 0.1);
      EXPECT_GE(layer.end, exact.end - 0.1);
      // Not more than a ray may run in the last step of the walk.
      EXPECT_TRUE(test::holds("C34", test::apart(layer.begin, exact.begin), test::atMost(30), "m"));
      EXPECT_TRUE(test::holds("C34", test::apart(layer.end, exact.end), test::atMost(30), "m"));
      const f64::RaySpan underBase = f64::bentRayUnder(eyeM - baseM, direction.y, f64::rayBend(direction));
      dipping += underBase.begin > layer.begin && underBase.end < layer.end;
    }
  }
  EXPECT_GT(dipping, 5) << "no ray leaves the base twice";
  EXPECT_TRUE(found > 500 && none > 500) << found << ' ' << none;
}

TEST(Stability, C34_theReferenceMarchTakesBothPartsOfADip) {
  // A homogeneous shell, from 100 m above its base, in directions that dip below it and come back within 60
  // km: what is left is that of the length within the layer, by the walk. The air between the parts counts
  // for nothing.
  const MarchMedium shell{[](const glm::dvec3&) { return 2e-5; }, 1500, 2500, 1e9, true};
  int dips = 0;
  for (const double degrees : {-0.36, -0.34, -0.33}) {
    const glm::dvec3 direction = directionOf(std::sin(degrees * std::numbers::pi / 180), 2.0);
    const double bend = f64::rayBend(direction);
    const f64::RaySpan under = f64::bentRayUnder(100, direction.y, bend);
    if (under.begin < 0 || under.end > kMostDistanceM) continue;
    ++dips;
    const double inside = kMostDistanceM - (under.end - under.begin);
    const MarchResult result =
        referenceMarch(shell, {}, {{0, 1600, 0}, direction, 0, kMostDistanceM}, {60000, 1});
    EXPECT_TRUE(test::holds("C34", test::apart(result.transmittance, std::exp(-2e-5 * inside)),
                            test::atMost(2e-5), "transmittance"))
        << degrees;
  }
  EXPECT_GE(dips, 2);
}

}  // namespace
}  // namespace skydrop::clouds
