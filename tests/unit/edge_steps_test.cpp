// Where edges are found in depth, and how much of a pixel lies beyond one (shaders/shared/edge_steps.glsl).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "skydrop/core/hash.h"
#include "skydrop/core/shared_edges.h"

namespace skydrop::core::shared {
namespace {

constexpr auto kLeast = 0.015f;  // exact enough in float and in double

TEST(EdgeSteps, aPlaneHasNone) {
  // Reversed depth is linear over it, up to the pixel before its horizon.
  RandomStream random{11, 0};
  for (int i = 0; i < 10000; ++i) {
    const auto step = static_cast<float>(std::pow(10.0, -8 + 7 * random.nextUnit()));
    const auto first = static_cast<float>(step * (0.01 + 1000 * std::pow(random.nextUnit(), 4.0)));
    const auto at = [&](int pixel) { return first + static_cast<float>(pixel) * step; };
    EXPECT_FALSE(f32::isStep(at(0), at(1), at(2), at(3), kLeast)) << first << " + n " << step;
    EXPECT_FALSE(f32::isStep(at(3), at(2), at(1), at(0), kLeast)) << first << " + n " << step;
  }
}

TEST(EdgeSteps, anEvenSkyAndTheFoldOfARoofHaveNone) {
  EXPECT_FALSE(f64::isStep(0, 0, 0, 0, kLeast));
  // The surface turns away between the pixels, without a gap.
  EXPECT_FALSE(f64::isStep(0.0100, 0.0104, 0.0108, 0.0106, kLeast));
  EXPECT_FALSE(f64::isStep(0.0100, 0.0104, 0.0104, 0.0104, kLeast));
}

TEST(EdgeSteps, aSurfaceThatEndsHasOne) {
  const double nearM = 0.1;
  // A hill before the sky, one before another 2 % farther away, and a slope that recedes towards its crest.
  EXPECT_TRUE(f64::isStep(nearM / 500, nearM / 510, 0, 0, kLeast));
  EXPECT_TRUE(f64::isStep(0, 0, nearM / 60'000, nearM / 59'000, kLeast));
  EXPECT_TRUE(f64::isStep(nearM / 5000, nearM / 5000, nearM / 5100, nearM / 5100, kLeast));
  EXPECT_FALSE(f64::isStep(nearM / 5000, nearM / 5000, nearM / 5040, nearM / 5040, kLeast));
  EXPECT_TRUE(f64::isStep(nearM / 400, nearM / 450, nearM / 900, nearM / 905, kLeast));
  // A trunk, one pixel wide, has one on either side.
  EXPECT_TRUE(f64::isStep(nearM / 900, nearM / 900, nearM / 50, nearM / 900, kLeast));
  EXPECT_TRUE(f64::isStep(nearM / 900, nearM / 50, nearM / 900, nearM / 900, kLeast));
}

// Of pixel `at`, by points on the line that a run stands for.
f64::Vec2 sampledShares(int at, int length, double begin, double end) {
  constexpr int kPoints = 4000;
  f64::Vec2 sum(0);
  for (int i = 0; i < kPoints; ++i) {
    const double place = (at + (i + 0.5) / kPoints) / length;
    const double height = place < 0.5 ? 0.5 * begin * (1 - 2 * place) : 0.5 * end * (2 * place - 1);
    sum += f64::Vec2(std::max(-height, 0.0), std::max(height, 0.0)) / static_cast<double>(kPoints);
  }
  return sum;
}

TEST(EdgeSteps, sharesAreTheAreasBesideTheLine) {
  for (int length = 1; length <= 70; ++length) {
    for (const double begin : {-1.0, 0.0, 1.0}) {
      for (const double end : {-1.0, 0.0, 1.0}) {
        for (int at = 0; at < length; ++at) {
          const f64::Vec2 shares = f64::stepShares(at, length, begin, end);
          const f64::Vec2 expected = sampledShares(at, length, begin, end);
          ASSERT_NEAR(shares.x, expected.x, 1e-3) << at << " of " << length << ", " << begin << ", " << end;
          ASSERT_NEAR(shares.y, expected.y, 1e-3) << at << " of " << length << ", " << begin << ", " << end;
          ASSERT_LE(shares.x + shares.y, 0.5);
          const f32::Vec2 single = f32::stepShares(static_cast<float>(at), static_cast<float>(length),
                                                   static_cast<float>(begin), static_cast<float>(end));
          ASSERT_NEAR(static_cast<double>(single.x), shares.x, 1e-6);
          ASSERT_NEAR(static_cast<double>(single.y), shares.y, 1e-6);
        }
      }
    }
  }
}

TEST(EdgeSteps, theSameFromEitherEndAndFromEitherSide) {
  for (int length = 1; length <= 40; ++length) {
    for (int at = 0; at < length; ++at) {
      const f64::Vec2 shares = f64::stepShares(at, length, -1, 1);
      const f64::Vec2 fromTheEnd = f64::stepShares(length - 1 - at, length, 1, -1);
      const f64::Vec2 turned = f64::stepShares(at, length, 1, -1);
      EXPECT_NEAR(shares.x, fromTheEnd.x, 1e-12);
      EXPECT_NEAR(shares.y, fromTheEnd.y, 1e-12);
      EXPECT_EQ(shares.x, turned.y);
      EXPECT_EQ(shares.y, turned.x);
    }
  }
}

TEST(ToneCurve, isUndoneByItsInverse) {
  RandomStream random{12, 0};
  const auto light = [&] { return static_cast<float>(std::pow(2.0, -10 + 26 * random.nextUnit()) - 1e-3); };
  for (int i = 0; i < 20000; ++i) {
    const f32::Vec3 seen = glm::clamp(f32::Vec3(light(), light(), light()), 0.0f, 65504.0f);
    const f32::Vec3 back = f32::lightOfToneCurve(f32::toneCurve(seen));
    for (int c = 0; c < 3; ++c) {
      // What the screen shows, in steps of 8 bits.
      EXPECT_NEAR(255 * f32::srgbEncode(f32::toneMap(back))[c], 255 * f32::srgbEncode(f32::toneMap(seen))[c],
                  0.1)
          << seen.x << ' ' << seen.y << ' ' << seen.z;
    }
    const f64::Vec3 exact(seen);
    const f64::Vec3 undone = f64::lightOfToneCurve(f64::toneCurve(exact));
    // The inverse of the matrix has seven digits, and a dark channel beside a bright one keeps fewer.
    const double brightest = std::max({exact.x, exact.y, exact.z});
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(undone[c], exact[c], 1e-5 * brightest + 1e-9);
  }
}

TEST(ToneCurve, staysInRangeAtItsEnds) {
  for (const float y : {-0.0004f, 0.0f, 1e-20f, 0.5f, 1.0f, 1.0165f, 1.01654f}) {
    const f32::Vec3 light = f32::lightOfToneCurve(f32::Vec3(y));
    for (int c = 0; c < 3; ++c) EXPECT_TRUE(light[c] >= 0 && light[c] <= 65504) << y;
  }
  EXPECT_NEAR(f64::lightOfToneCurve(f64::toneCurve(f64::Vec3(0))).x, 0, 1e-9);
}

}  // namespace
}  // namespace skydrop::core::shared
