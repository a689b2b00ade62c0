// Drops far from the origin, late, fast, in downpours: the cells that hold them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

#include "skydrop/render/precipitation/drop_sets.h"
#include "support/margin.h"

namespace skydrop::render {
namespace {

// Of one class whose cells are 2 m wide, which is exact.
constexpr PrecipitationSettings kSettings{.drops = 8000, .rangeM = 20};
const std::vector<FallClass> kPellets = fallClasses({.sleet = 3});

View at(const glm::dvec3& eye) {
  View view;
  view.position = eye;
  return view;
}

bool isFinite(const DropSet& set) {
  const glm::vec4 sum = set.corner + set.passing + set.look + set.light;
  return std::isfinite(sum.x + sum.y + sum.z + sum.w);
}

TEST(Stability, W40_rainAtRestAndAt300MetresASecond) {
  // Finite, bounded in number, and the drops pass as fast as they should.
  test::noFaults("W40", "violations");
  for (const double speed : {0.0, 300.0}) {
    const glm::dvec3 eye(0, 0, -speed);
    const DropSets sets = dropSets(kSettings, kPellets, at({0, 400, 0}), eye, {7, 0, 0}, 100);
    ASSERT_EQ(sets.count, 2);
    for (int i = 0; i < sets.count; ++i) {
      const DropSet& set = sets.sets[static_cast<std::size_t>(i)];
      EXPECT_TRUE(isFinite(set));
      EXPECT_GT(set.counts.w, 0);
      EXPECT_LE(set.counts.w, kMostDropsASet);
      EXPECT_EQ(glm::vec3(set.passing), glm::vec3(7, -5, speed));
    }
  }
}

TEST(Stability, W41_rainABillionMetresOut) {
  // 2^32 cells away, 8.6e9 m, the cells are the same to the bit; 1e9 m out they still lie around the eye, and
  // are others than at the origin.
  test::noFaults("W41", "violations");
  const glm::dvec3 eye(12.5, 400.25, -7.75);
  const double period = 4294967296.0 * 2;
  const glm::dvec3 falling(0, 0, 0);
  const auto setsAt = [&](const glm::dvec3& place) {
    return dropSets(kSettings, kPellets, at(place), falling, {}, 0);
  };
  const DropSets here = setsAt(eye), far = setsAt(eye + glm::dvec3(period, 0, -period));
  ASSERT_EQ(here.count, far.count);
  EXPECT_EQ(std::memcmp(&here.sets, &far.sets, sizeof here.sets), 0);
  const DropSets out = setsAt(eye + glm::dvec3(1e9, 0, 1e9));
  for (int i = 0; i < out.count; ++i) {
    const DropSet& set = out.sets[static_cast<std::size_t>(i)];
    EXPECT_LT(glm::length(glm::vec3(set.corner)), 80) << "the box begins near the eye";
    EXPECT_NE(glm::uvec3(set.first), glm::uvec3(here.sets[static_cast<std::size_t>(i)].first));
  }
}

TEST(Stability, W42_rainAtTheFirstSecondAndAfterAMonth) {
  // From one step to the next cells move by what falls in it, within 1e-4 m, at 0 s and 30 days in; a wind
  // that has changed since moves nothing that is there now: no time since the beginning enters.
  for (const double seconds : {0.1, 2592000.1}) {
    constexpr double kStep = 1.0 / 120;
    const glm::dvec3 air(9, 0, -4);
    const DropSets now = dropSets(kSettings, kPellets, at({0, 400, 0}), {}, air, seconds),
                   next = dropSets(kSettings, kPellets, at({0, 400, 0}), {}, air, seconds + kStep);
    ASSERT_EQ(now.count, next.count);
    for (int i = 0; i < now.count; ++i) {
      const DropSet& a = now.sets[static_cast<std::size_t>(i)];
      const DropSet& b = next.sets[static_cast<std::size_t>(i)];
      EXPECT_EQ(a.first.w, b.first.w);
      const glm::ivec3 cells(glm::uvec3(b.first) - glm::uvec3(a.first));
      const glm::dvec3 moved =
          glm::dvec3(b.corner) - glm::dvec3(a.corner) - glm::dvec3(cells) * static_cast<double>(a.corner.w);
      const glm::dvec3 fallen = glm::dvec3(air.x, -kPellets[0].speedMps, air.z) * kStep;
      EXPECT_TRUE(test::holds("W42", glm::length(moved - fallen), test::below(1e-4), "m")) << seconds;
    }
    const DropSets gust = dropSets(kSettings, kPellets, at({0, 400, 0}), {}, air * 1.001, seconds);
    const glm::vec3 shift = glm::vec3(gust.sets[0].corner) - glm::vec3(now.sets[0].corner);
    EXPECT_TRUE(test::holds("W42", std::abs(std::remainder(static_cast<double>(shift.x), 2.0)),
                            test::below(0.1), "m"));
  }
}

TEST(Stability, W48_theTwoSetsOfAClassRelieveEachOtherWithoutALull) {
  // At any moment as many cells are filled, within rounding; a set that is replaced is empty then.
  for (double seconds = 0; seconds < 13; seconds += 0.05) {
    const DropSets sets = dropSets(kSettings, kPellets, at({0, 400, 0}), {}, {}, seconds);
    double filled = 0;
    for (int i = 0; i < sets.count; ++i)
      filled += static_cast<double>(sets.sets[static_cast<std::size_t>(i)].passing.w);
    EXPECT_TRUE(test::holds("W48", test::apart(filled, 1), test::atMost(1e-5), "of 1")) << seconds;
  }
}

}  // namespace
}  // namespace skydrop::render
