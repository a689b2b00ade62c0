#include "skydrop/flight/package.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "skydrop/core/error.h"
#include "skydrop/flight/environment.h"

namespace skydrop::flight {
namespace {

BodyState releasedAt(double height, double speed) {
  BodyState state;
  state.position = {0, height, 0};
  state.velocity = {0, 0, -speed};
  return state;
}

TEST(Package, parachuteOpensAfterASecondAndWithoutJumps) {
  // Closed for 1 s, open at 1.8 s, in between rising smoothly.
  const PackageSettings settings;
  EXPECT_EQ(parachuteOpenAt(settings, 0), 0);
  EXPECT_EQ(parachuteOpenAt(settings, 1), 0);
  EXPECT_EQ(parachuteOpenAt(settings, 1.8), 1);
  double before = 0;
  for (double age = 0; age < 3; age += 1.0 / 120) {
    const double open = parachuteOpenAt(settings, age);
    EXPECT_GE(open, before);
    EXPECT_LT(open - before, 0.02);
    before = open;
  }
}

TEST(Package, aLargerOrHeavierPackageTumblesSlowerAndFallsAlike) {
  // The same push at one end: the spin goes with 1 / (mass * size). The way down knows neither.
  const auto released = [](double mass, double size) {
    return Package({.mass = mass, .size = size}, releasedAt(500, 70)).state();
  };
  EXPECT_EQ(released(60, 0.8).angularVelocity.x, -1.2);
  EXPECT_DOUBLE_EQ(released(120, 0.8).angularVelocity.x, -0.6);
  EXPECT_DOUBLE_EQ(released(60, 1.6).angularVelocity.x, -0.6);
  EXPECT_EQ(released(1, 0.1).angularVelocity.x, -12) << "held to what the steps can follow";
  Package usual({}, releasedAt(500, 70)), heavy({.mass = 2000, .size = 5}, releasedAt(500, 70));
  for (int i = 0; i < 1200; ++i) {
    usual.step(glm::dvec3(3, 0, 0), 1.0 / 120);
    heavy.step(glm::dvec3(3, 0, 0), 1.0 / 120);
  }
  EXPECT_EQ(usual.state().position, heavy.state().position);
}

TEST(Package, fallsFastThenDriftsAtTheParachutesSpeed) {
  // At 1 s it still flies fast; 10 s later it sinks at 8 m/s and hangs straight under its canopy.
  Package package({}, releasedAt(500, 70));
  for (int i = 0; i < 120; ++i) package.step(glm::dvec3(0), 1.0 / 120);
  EXPECT_GT(glm::length(package.state().velocity), 55);
  for (int i = 0; i < 1200; ++i) package.step(glm::dvec3(0), 1.0 / 120);
  EXPECT_NEAR(package.state().velocity.y, -8, 0.01);
  EXPECT_LT(std::abs(package.state().velocity.z), 0.01);
  const glm::dvec3 up = package.state().orientation * glm::dvec3(0, 1, 0);
  EXPECT_GT(up.y, 0.99);
}

// State after 3 s of a fall in wind whose canopy begins to open, and is open, within steps.
BodyState fallen(double opening, int rate) {
  Package package({.parachuteDelay = 0.9137, .parachuteOpening = opening}, releasedAt(500, 70));
  for (int i = 0; i < 3 * rate; ++i) package.step({5, 0, 2}, 1.0 / rate);
  return package.state();
}

TEST(Package, theErrorFallsWithTheFourthPowerOfTheStepAlsoOverTheOpening) {
  // Steps of 1/20 against 1/80 s, held against 1/1280 s, with an opening that takes time and one at once.
  // What is exact (the fall, where the canopy opens at once) has rounding alone: 1e-9 over 500 m and
  // thousands of steps.
  for (const double opening : {0.7321, 0.0}) {
    const BodyState truth = fallen(opening, 1280), coarse = fallen(opening, 20), fine = fallen(opening, 80);
    const auto order = [&](auto value) {
      const double worse = glm::length(value(coarse) - value(truth)),
                   better = glm::length(value(fine) - value(truth));
      return worse < 1e-9 ? 4 : std::log(worse / better) / std::log(4.0);
    };
    EXPECT_GT(order([](const BodyState& s) { return s.position; }), 3.7) << opening;
    EXPECT_GT(order([](const BodyState& s) { return s.velocity; }), 3.7) << opening;
    EXPECT_GT(order([](const BodyState& s) { return s.orientation; }), 3.7) << opening;
    EXPECT_GT(order([](const BodyState& s) { return s.angularVelocity; }), 3.7) << opening;
  }
}

TEST(Package, driftsWithTheWind) {
  // Under the canopy it moves with the air, whatever it was released with.
  Package package({}, releasedAt(500, 70));
  const glm::dvec3 wind{7, 0, 3};
  for (int i = 0; i < 1800; ++i) package.step(wind, 1.0 / 120);
  EXPECT_LT(glm::length(package.state().velocity - (wind - glm::dvec3(0, 8, 0))), 0.01);
}

TEST(Package, aLandedPackageStaysWhereItIs) {
  // After land() no step moves or turns it, and its age stands still.
  Package package({}, releasedAt(500, 70));
  package.step(glm::dvec3(0), 1.0 / 120);
  package.land({1, 2, 3});
  const glm::dquat orientation = package.state().orientation;
  const double age = package.age();
  for (int i = 0; i < 100; ++i) package.step({5, 5, 5}, 1.0 / 120);
  EXPECT_EQ(package.state().position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(package.state().velocity, glm::dvec3(0));
  EXPECT_EQ(package.state().orientation, orientation);
  EXPECT_EQ(package.age(), age);
}

TEST(Package, impossiblePackagesAreRefused) {
  // Speeds, mass and size must be positive, times not negative, all of them finite.
  const double kNaN = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {0.0, -1.0, kNaN}) {
    PackageSettings s;
    s.parachuteSpeed = bad;
    EXPECT_THROW(Package(s, releasedAt(1, 1)), core::RangeError);
  }
  PackageSettings late;
  late.parachuteDelay = -1;
  EXPECT_THROW(Package(late, releasedAt(1, 1)), core::RangeError);
}

TEST(Package, predictionOutsideAnySenseIsEmpty) {
  // A state that is not finite has no landing point; one below the ground lands at once, on the ground.
  const auto flat = [](const glm::dvec2&) { return 50.0; };
  const double kNaN = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(predictLanding({}, {{0, kNaN, 0}, {0, 0, 0}}, glm::dvec3(0), flat));
  const auto below = predictLanding({}, {{3, 10, 4}, {70, 0, 0}}, glm::dvec3(0), flat);
  ASSERT_TRUE(below);
  EXPECT_EQ(below->position, glm::dvec3(3, 50, 4));
  EXPECT_EQ(below->seconds, 0);
}

TEST(Package, predictionSeesARidgeInTheWay) {
  // A ridge with slopes of 45 degrees stands in the middle of the 130 m that the package travels: it lands on
  // its near side.
  const auto ridge = [](const glm::dvec2& xz) { return std::max(0.0, 160 - std::abs(xz.y + 80)); };
  const auto landing = predictLanding({}, {{0, 158, 0}, {0, 0, -70}}, glm::dvec3(0), ridge);
  ASSERT_TRUE(landing);
  EXPECT_GT(landing->position.z, -90);
  EXPECT_NEAR(landing->position.y, ridge({landing->position.x, landing->position.z}), 1e-9);
}

}  // namespace
}  // namespace skydrop::flight
