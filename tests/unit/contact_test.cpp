#include "skydrop/game/contact.h"

#include <gtest/gtest.h>

#include <cmath>

#include "skydrop/terrain/analytic_height_sources.h"

namespace skydrop::game {
namespace {

std::optional<Contact> sweep(const terrain::HeightSource& ground, const glm::dvec3& from,
                             const glm::dvec3& to, double margin) {
  return sweepContact(ground, from, to, margin, clearanceAt(ground, from), clearanceAt(ground, to));
}

TEST(Contact, onAPlaneItIsTheIntersectionWithinAMillimetre) {
  // A tilted plane met at an angle, with and without a margin: the closed form of the crossing, along the way
  // to 1 mm, and never on its far side.
  const auto plane = terrain::makeTiltedPlaneSource(100, {0.3, -0.2});
  const glm::dvec3 from{0, 130, 0}, to{5, 96, -3};
  for (const double margin : {0.0, 1.5}) {
    // 130 - 34 t = 100 + .3 (5 t) - .2 (-3 t) + margin
    const double truth = (30 - margin) / (34 + 1.5 + 0.6);
    const auto hit = sweep(*plane, from, to, margin);
    ASSERT_TRUE(hit);
    const double length = std::sqrt(25.0 + 34 * 34 + 9);
    EXPECT_NEAR(hit->fraction * length, truth * length, 1e-3);
    EXPECT_GE(clearanceAt(*plane, hit->position), margin - 1e-9);
    EXPECT_FALSE(hit->water);
  }
}

TEST(Contact, aWayThatStaysClearHasNone) {
  // Level flight a metre above flat land, a climb away from it, and no way at all.
  const auto flat = terrain::makeFlatSource(10);
  EXPECT_FALSE(sweep(*flat, {0, 11, 0}, {6, 11, 0}, 0.5));
  EXPECT_FALSE(sweep(*flat, {0, 10.6, 0}, {1, 20, 0}, 0.5));
  EXPECT_FALSE(sweep(*flat, {0, 11, 0}, {0, 11, 0}, 0.5));
}

TEST(Contact, aStartThatIsTooLowIsLiftedOntoTheSurface) {
  // Already inside the margin, or below the ground: a contact at once, at the margin above the surface.
  const auto flat = terrain::makeFlatSource(10);
  for (const double y : {10.2, 3.0, -500.0}) {
    const auto hit = sweep(*flat, {0, y, 0}, {1, 50, 0}, 0.5);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->fraction, 0);
    EXPECT_EQ(hit->position.y, 10.5);
  }
}

TEST(Contact, theSeaStopsWhatFallsBesideTheLand) {
  // Over sea floor at -30 the surface is water at 0.
  const auto floor = terrain::makeFlatSource(-30);
  const auto hit = sweep(*floor, {0, 5, 0}, {0, -5, 0}, 0);
  ASSERT_TRUE(hit);
  EXPECT_TRUE(hit->water);
  EXPECT_NEAR(hit->position.y, 0, 1e-9);
  EXPECT_NEAR(hit->fraction, 0.5, 1e-3);
}

TEST(Contact, aCliffIsMetAtItsFace) {
  // A step of 200 m in the way of a level flight: the contact lies at its edge within 25 cm of way, on top of
  // nothing.
  const auto cliff = terrain::makeStepSource(3, 0, 200);
  const auto hit = sweep(*cliff, {0, 50, 0}, {6, 50, 0}, 1);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->fraction * 6, 3, 0.02);
}

}  // namespace
}  // namespace skydrop::game
