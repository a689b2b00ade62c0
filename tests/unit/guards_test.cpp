#include "skydrop/core/guards.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "skydrop/core/deterministic_math.h"
#include "skydrop/core/fixed_step.h"
#include "skydrop/core/guard_watch.h"
#include "skydrop/core/shared_guard_marks.h"

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

TEST(Guards, aWatchTellsWhatFiredSinceTheLastLook) {
  // By name and number, those of earlier looks with none; a reset begins anew.
  resetGuardCounts();
  GuardWatch watch;
  EXPECT_TRUE(watch.look().empty());
  countGuard(Guard::stiffStep, 3);
  EXPECT_EQ(watch.look(), (std::vector<FiredGuard>{{Guard::stiffStep, 3, 3}}));
  countGuard(Guard::arcSineDomain);
  countGuard(Guard::stiffStep);
  EXPECT_EQ(watch.look(), (std::vector<FiredGuard>{{Guard::arcSineDomain, 1, 1}, {Guard::stiffStep, 1, 4}}));
  EXPECT_EQ(watch.look(), (std::vector<FiredGuard>{{Guard::arcSineDomain, 0, 1}, {Guard::stiffStep, 0, 4}}));
  resetGuardCounts();
  countGuard(Guard::stiffStep, 2);
  EXPECT_EQ(watch.look(), (std::vector<FiredGuard>{{Guard::stiffStep, 2, 2}}));
}

TEST(Guards, stepsThatAreNotCaughtUpAreCounted) {
  // Ten seconds are 1200 steps, of which 30 are made; a frame that is just long enough drops none.
  resetGuardCounts();
  FixedStep clock;
  clock.advance(0.25);
  EXPECT_EQ(guardCount(Guard::stepsDropped), 0u);
  EXPECT_EQ(clock.advance(10), 30);
  EXPECT_EQ(guardCount(Guard::stepsDropped), 1170u);
}

TEST(Guards, theShadingTellsLightThatIsCutNegativeOrNoNumberApart) {
  // Of three channels the worst, in float as in double; colours of their own, everything else at half
  // brightness.
  const float nan = std::nanf(""), inf = std::numeric_limits<float>::infinity();
  struct Case {
    glm::vec3 light;
    float guard;
  };
  const Case cases[] = {{{0, 0, 0}, shared::f32::kNoGuard},
                        {{-0.0f, 1, 59999}, shared::f32::kNoGuard},
                        {{1, 60000, 1}, shared::f32::kBrightestGuard},
                        {{60000, -1e-30f, 0}, shared::f32::kNegativeGuard},
                        {{-1, nan, 60000}, shared::f32::kNotFiniteGuard},
                        {{inf, 0, 0}, shared::f32::kNotFiniteGuard},
                        {{0, 0, -inf}, shared::f32::kNotFiniteGuard}};
  for (const Case& of : cases) {
    EXPECT_EQ(shared::f32::guardOfLight(of.light), of.guard)
        << of.light.x << ' ' << of.light.y << ' ' << of.light.z;
    EXPECT_EQ(shared::f64::guardOfLight(glm::dvec3(of.light)), of.guard);
  }
  EXPECT_EQ(shared::f32::guardMarked({0.5f, 1, 0.25f}, shared::f32::kNoGuard),
            glm::vec3(0.25f, 0.5f, 0.125f));
  EXPECT_EQ(shared::f32::guardMarked({0.5f, 1, 0.25f}, shared::f32::kBrightestGuard), glm::vec3(1, 1, 0));
  EXPECT_EQ(shared::f32::guardMarked({0.5f, 1, 0.25f}, shared::f32::kNegativeGuard), glm::vec3(0, 1, 1));
  EXPECT_EQ(shared::f32::guardMarked({0.5f, 1, 0.25f}, shared::f32::kNotFiniteGuard), glm::vec3(1, 0, 1));
}

}  // namespace
}  // namespace skydrop::core
