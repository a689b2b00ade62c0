#include "skydrop/core/wind.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace skydrop::core {
namespace {

TEST(Wind, blowsFromItsDirection) {
  // As a weather report gives it: north wind (0) blows south (+z), east wind (90) west (-x).
  struct Case {
    double from;
    glm::dvec2 towards;
  };
  for (const Case& c :
       {Case{0, {0, 1}}, Case{90, {-1, 0}}, Case{180, {0, -1}}, Case{270, {1, 0}}, Case{360, {0, 1}}}) {
    const glm::dvec2 drift = windDrift({.speed = 5, .direction = c.from}, 60);
    EXPECT_NEAR(drift.x, 300 * c.towards.x, 1e-9) << c.from;
    EXPECT_NEAR(drift.y, 300 * c.towards.y, 1e-9) << c.from;
  }
}

TEST(Wind, movesTheAircraftWhereItIsToldTo) {
  // With the velocity that clouds drift with; else the air stands still, to the last bit.
  const WindSettings still{.speed = 12, .direction = 250};
  EXPECT_EQ(flownWind(still), glm::dvec3(0));
  const WindSettings moving{.speed = 12, .direction = 250, .movesAircraft = true};
  const glm::dvec2 second = windDrift(moving, 1);
  EXPECT_EQ(flownWind(moving), glm::dvec3(second.x, 0, second.y));
  EXPECT_NEAR(glm::length(second), 12, 1e-12);
}

}  // namespace
}  // namespace skydrop::core
