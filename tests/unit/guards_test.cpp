#include "skydrop/core/guards.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "skydrop/core/deterministic_math.h"

namespace skydrop::core {
namespace {

TEST(Guards, everyGuardHasANameOfItsOwn) {
  // The statistics list the counts by name, so no two may share one.
  std::set<std::string_view> names;
  for (int i = 0; i < static_cast<int>(Guard::count_); ++i) names.insert(guardName(static_cast<Guard>(i)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(Guard::count_));
  EXPECT_FALSE(names.contains("unknown"));
}

TEST(Guards, arcSineClampsRoundingSilentlyAndCountsWhatIsMore) {
  // One ulp past 1 is rounding; a thousandth past 1 is worth knowing about. Both give pi/2.
  resetGuardCounts();
  EXPECT_EQ(safeAsin(std::nextafter(1.0, 2.0)), dmath::kHalfPi);
  EXPECT_EQ(guardCount(Guard::arcSineDomain), 0u);
  EXPECT_EQ(safeAsin(-1.001), -dmath::kHalfPi);
  EXPECT_EQ(guardCount(Guard::arcSineDomain), 1u);
}

TEST(Guards, squareRootOfANegativeIsZeroAndCounted) {
  // Below zero by rounding or more, the root is 0, never NaN.
  resetGuardCounts();
  EXPECT_EQ(safeSqrt(-1e-18), 0);
  EXPECT_EQ(guardCount(Guard::squareRootDomain), 0u);
  EXPECT_EQ(safeSqrt(-1), 0);
  EXPECT_EQ(guardCount(Guard::squareRootDomain), 1u);
  EXPECT_EQ(safeSqrt(9), 3);
}

TEST(Guards, directionOfATinyVectorIsRightAndOfNoneTheFallback) {
  // 1e-140 squared would vanish, 1e200 squared overflow: both still have a direction; zero and NaN do not.
  resetGuardCounts();
  const glm::dvec3 up{0, 1, 0};
  EXPECT_NEAR(safeNormalize({3e-140, 4e-140, 0}, up).x, 0.6, 1e-15);
  EXPECT_NEAR(safeNormalize({3e200, 4e200, 0}, up).y, 0.8, 1e-15);
  EXPECT_EQ(guardCount(Guard::zeroDirection), 0u);
  EXPECT_EQ(safeNormalize({0, 0, 0}, up), up);
  EXPECT_EQ(safeNormalize({std::nan(""), 0, 0}, up), up);
  EXPECT_EQ(guardCount(Guard::zeroDirection), 2u);
}

}  // namespace
}  // namespace skydrop::core
