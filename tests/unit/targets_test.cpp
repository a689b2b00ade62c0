#include "game/targets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "skydrop/core/guards.h"

namespace skydrop::game {
namespace {

// Land by a lambda: height and slope at (x, z).
class Land final : public terrain::HeightSource {
 public:
  explicit Land(std::function<terrain::HeightSample(glm::dvec2)> at) : at_(std::move(at)) {}
  terrain::HeightSample sample(glm::dvec2 xz) const override { return at_(xz); }
  terrain::HeightBounds bounds(glm::dvec2, glm::dvec2) const override { return range(); }
  terrain::HeightBounds range() const override { return {-1000, 3000}; }

 private:
  std::function<terrain::HeightSample(glm::dvec2)> at_;
};

void expectAll(const Land& land, const std::function<bool(const glm::dvec3&)>& good) {
  core::RandomStream random{1, 0};
  for (int i = 0; i < 300; ++i) {
    const auto target = drawTarget(land, {500, 300, -700}, {}, random);
    ASSERT_TRUE(target);
    EXPECT_TRUE(good(*target)) << target->x << " " << target->y << " " << target->z;
  }
}

TEST(Targets, fillTheRingAndNothingElse) {
  // On flat land: every one 2 to 6 km away, spread evenly over the ring's area (half of it lies beyond 4472
  // m; the share of 300 draws has a standard error of .03).
  const Land flat([](glm::dvec2) { return terrain::HeightSample{50, {0, 0}}; });
  int beyond = 0;
  core::resetGuardCounts();
  expectAll(flat, [&](const glm::dvec3& t) {
    const double distance = glm::length(glm::dvec2(t.x - 500, t.z + 700));
    beyond += distance > 4472;
    return distance >= 2000 && distance <= 6000 && t.y == 50;
  });
  EXPECT_NEAR(beyond / 300.0, 0.5, 0.1);
  EXPECT_EQ(core::guardCount(core::Guard::targetWidened), 0u);
}

TEST(Targets, avoidTheSeaTheBeachAndCirclesThatReachIntoTheWater) {
  // Sea in the west, a beach of 1 m in the middle, land in the east: centres lie on the land, 70 m from the
  // water.
  const Land coast([](glm::dvec2 xz) {
    return terrain::HeightSample{xz.x < 0 ? -5.0 : xz.x < 40 ? 1.0 : 30.0, {0, 0}};
  });
  expectAll(coast, [](const glm::dvec3& t) { return t.x > 70 * 0.99 && t.y == 30; });
  const Land beach([](glm::dvec2 xz) { return terrain::HeightSample{xz.x < 1000 ? 1.0 : 30.0, {0, 0}}; });
  expectAll(beach, [](const glm::dvec3& t) { return t.y == 30; });
}

TEST(Targets, avoidSlopesOverTwentyDegrees) {
  // Slopes of 25 degrees in the north, 15 in the south: all targets lie in the south.
  const Land slopes([](glm::dvec2 xz) {
    return terrain::HeightSample{100, {xz.y < 0 ? std::tan(25 / 57.29578) : std::tan(15 / 57.29578), 0}};
  });
  expectAll(slopes, [](const glm::dvec3& t) { return t.z >= 0; });
}

TEST(Targets, areSearchedFurtherOutWhereThereIsNoLandNear) {
  // An island 12 km away is found, and the widening counted; without any land the answer is none.
  const Land island([](glm::dvec2 xz) { return terrain::HeightSample{xz.x > 12000 ? 20.0 : -20.0, {0, 0}}; });
  core::resetGuardCounts();
  expectAll(island, [](const glm::dvec3& t) { return t.x > 12000; });
  EXPECT_GT(core::guardCount(core::Guard::targetWidened), 0u);
  const Land sea([](glm::dvec2) { return terrain::HeightSample{-20, {0, 0}}; });
  core::RandomStream random{1, 0};
  EXPECT_FALSE(drawTarget(sea, {0, 0, 0}, {}, random));
}

}  // namespace
}  // namespace skydrop::game
