#include "skydrop/flight/rotation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace skydrop::flight {
namespace {

TEST(Rotation, identityFacesNorthWithWingsLevel) {
  // The body's forward axis is -z, which is north: heading, pitch and bank are 0.
  const Attitude read = attitudeOf(glm::dquat(1, 0, 0, 0));
  EXPECT_EQ(read.headingRad, 0);
  EXPECT_EQ(read.pitchRad, 0);
  EXPECT_EQ(read.bankRad, 0);
}

TEST(Rotation, signsAreAPilotsSigns) {
  // Heading 90 degrees looks east, pitch is nose up, bank is right wing down; each within rounding.
  const glm::dquat q = orientationOf({std::numbers::pi / 2, 0.3, 0.2});
  const glm::dvec3 forward = q * glm::dvec3(0, 0, -1), right = q * glm::dvec3(1, 0, 0);
  EXPECT_NEAR(forward.x, std::cos(0.3), 1e-15);
  EXPECT_NEAR(forward.y, std::sin(0.3), 1e-15);
  EXPECT_NEAR(right.y, -std::sin(0.2) * std::cos(0.3), 1e-15);
  EXPECT_GT(right.z, 0);  // facing east, the right hand is in the south
}

TEST(Rotation, exponentialMapHasNoSeamBetweenSeriesAndFunctions) {
  // Just below and above half a radian, where the two branches meet, quaternions agree with sine and cosine
  // within an ulp or two.
  for (const double angle : {0.0, 1e-200, 1e-9, 0.4999999999, 0.5, 0.5000000001, 3.0, 6.2, 1000.0}) {
    const glm::dquat q = exponentialMap({0, angle, 0});
    EXPECT_NEAR(q.w, std::cos(angle / 2), 3e-16) << angle;
    EXPECT_NEAR(q.y, std::sin(angle / 2), 3e-16) << angle;
    EXPECT_EQ(q.x, 0);
  }
}

TEST(Rotation, logarithmUndoesTheExponentialUpToHalfATurn) {
  // Any rotation vector shorter than pi comes back within 1e-14; a longer one comes back the short way.
  const glm::dvec3 axis = glm::normalize(glm::dvec3(1, 2, -2));
  for (const double angle : {0.0, 1e-13, 1e-5, 1.0, 3.1}) {
    EXPECT_LT(glm::length(logarithmMap(exponentialMap(axis * angle)) - axis * angle), 1e-14) << angle;
  }
  EXPECT_NEAR(glm::length(logarithmMap(exponentialMap(axis * 4.0))), 2 * std::numbers::pi - 4, 1e-14);
}

}  // namespace
}  // namespace skydrop::flight
