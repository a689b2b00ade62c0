// Cases that the hunt found in the modules (docs/hunt.md): the input, what the former or the obvious code
// makes of it, and what must hold. X43 on were right already; they are inputs at which the obvious code is
// not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <limits>

#include "skydrop/core/angles.h"
#include "skydrop/core/error.h"
#include "skydrop/core/fixed_step.h"
#include "skydrop/core/guards.h"
#include "skydrop/flight/linear_drag.h"
#include "skydrop/flight/rigid_body.h"
#include "skydrop/flight/rotation.h"
#include "skydrop/render/frame/camera.h"
#include "skydrop/sky/almanac.h"
#include "skydrop/terrain/chunk_grid.h"
#include "skydrop/terrain/height_range.h"
#include "skydrop/weather/dryden.h"
#include "skydrop/weather/icing.h"
#include "skydrop/weather/standard_atmosphere.h"
#include "skydrop/weather/state.h"
#include "support/margin.h"

namespace skydrop {
namespace {

using test::apart, test::atMost, test::holds;

constexpr double kPi = glm::pi<double>();
constexpr double kEndless = std::numeric_limits<double>::infinity();
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double formerlyWrapped(double degrees) {
  const double within = degrees - 360 * std::floor(degrees / 360);
  return within < 360 ? within : 0;
}

// How far an angle lies outside [0, 360).
double outside(double degrees) {
  return degrees >= 0 && degrees < 360 ? 0 : std::max(std::abs(degrees), 1.0);
}

TEST(Stability, X28_aWindFromAHairWestOfNorthIsWithinTheCompass) {
  // The quotient of the least double by 360 is -0, and so was its floor.
  EXPECT_LT(formerlyWrapped(-5e-324), 0);
  EXPECT_TRUE(
      holds("X28", outside(weather::mixedDirection(-5e-324, 1, -5e-324, 1, 0.5)), atMost(0), "degrees"));
  EXPECT_EQ(core::wrappedDegrees(-1e-20), 0);
  EXPECT_EQ(core::wrappedDegrees(720), 0);
  EXPECT_EQ(core::wrappedDegrees(-90), 270);
}

TEST(Stability, X29_anyLongitudeHasASiderealTime) {
  const double longitude = -1.594633814317078e22;
  EXPECT_GT(outside(formerlyWrapped(longitude)), 1);
  EXPECT_TRUE(
      holds("X29", outside(sky::siderealDegrees(-335390.50721059123, longitude)), atMost(0), "degrees"));
}

TEST(Stability, X30_X31_directionsOfAnyLengthStandSomewhere) {
  // Squares of 1e-205 are none and of 1e205 infinite: azimuth 0, elevation 0.
  EXPECT_EQ(3e-205 * 3e-205, 0);
  EXPECT_TRUE(std::isinf(3e205 * 3e205));
  const sky::Horizontal place{149.2, 41};
  for (const auto& [id, length] : {std::pair("X30", 3e-205), std::pair("X31", 3e205)}) {
    const sky::Horizontal back = sky::horizontalOf(sky::worldDirection(place) * length);
    EXPECT_TRUE(holds(id, std::max(apart(back.azimuthDegrees, 149.2), apart(back.elevationDegrees, 41)),
                      atMost(1e-10), "degrees"));
  }
}

TEST(Stability, X32_noTorqueTakesAwayTheAttitude) {
  // A step after which the rate is finite and its square is not left an attitude of length 0, which is
  // finite.
  for (const double torque : {1e30, 1e100, 1e160, 1e200, 1e300}) {
    for (const double dt : {1.0 / 120, 1.0, 1e10, 1e30}) {
      flight::RigidBody body(1, {0, 0, 0}, {1, 0, 0, 0}, glm::dmat3(0.1));
      body.applyRelativeTorque({torque, -torque, torque / 3});
      body.update(dt);
      body.update(dt);
      EXPECT_TRUE(holds("X32", apart(glm::length(body.orientation()), 1), atMost(1e-9), ""))
          << torque << " " << dt;
    }
  }
}

TEST(Stability, X33_upsideDownIsABankOfPlusPi) {
  EXPECT_EQ(std::atan2(-0.0, -1.0), -kPi);
  for (const glm::dquat& q : {glm::dquat(0, 0, 0, 1), glm::dquat(0, 0, 0, -1), glm::dquat(-0.0, 0, -0.0, 1),
                              glm::dquat(1e-300, 0, 0, 1), glm::dquat(-1e-300, 0, 0, 1)})
    EXPECT_TRUE(holds("X33", apart(flight::attitudeOf(q).bankRad, kPi), atMost(1e-12), "rad"));
}

TEST(Stability, X43_hardlyAnyDragIsTheParabola) {
  const double k = 1e-18;
  EXPECT_EQ((1 - std::exp(-k * 10)) / k, 0) << "the obvious code: it does not move";
  const flight::PointState end = flight::fallWithLinearDrag({{0, 0, 0}, {50, 0, 0}}, k, {0, 0, 0}, 10);
  EXPECT_TRUE(holds("X43", apart(end.position.x, 500), atMost(1e-9), "m"));
}

TEST(Stability, X44_aHairWestOfABorderIsTheWesternChunk) {
  const double border = 960000, place = std::nextafter(border, 0);
  EXPECT_EQ(std::floor(static_cast<float>(place) / 960), 1000) << "the obvious code: the eastern one";
  EXPECT_TRUE(holds("X44", apart(terrain::gridIndex(place, 960), 999), atMost(0), "chunks"));
}

TEST(Stability, X45_heightsThatAreNoneHaveTheCodeOfAnEnd) {
  const terrain::HeightRange range;
  double worst = 0;
  for (const auto& [height, code] :
       {std::pair(kNone, 0), {-kEndless, 0}, {kEndless, 65535}, {1e300, 65535}, {-1e300, 0}})
    worst = std::max(worst, apart(int{range.encode(height)}, code));
  EXPECT_TRUE(holds("X45", worst, atMost(0), "codes"));
}

TEST(Stability, X46_theLeastTurnIsATurn) {
  // Of 1e-170 rad: the square of the angle is 0, and sin(a) / a was 0 / 0.
  const glm::dvec3 v(1e-170, 0, 0);
  EXPECT_TRUE(std::isnan(std::sin(glm::length(v)) / glm::length(v)));
  EXPECT_TRUE(holds("X46", apart(glm::length(flight::exponentialMap(v)), 1), atMost(1e-15), ""));
}

TEST(Stability, X47_vectorsOf1e200AreNormalised) {
  const glm::dvec3 v(3e200, 0, 4e200);
  EXPECT_EQ(glm::length(v / std::sqrt(glm::dot(v, v))), 0);
  EXPECT_TRUE(holds("X47", apart(core::safeNormalize(v, {0, 1, 0}).x, 0.6), atMost(1e-15), ""));
}

TEST(Stability, X48_X49_thereIsAirAtAnyHeight) {
  // The law of the lowest layer goes on to 0 K at 44 km, and its power to NaN.
  EXPECT_TRUE(std::isnan(std::pow(1 - 0.0065 * 50000 / 288.15, 5.2559)));
  double worst = 0;
  for (const double height : {1e5, 1e12, 1e30, kEndless, -kEndless, -6356766.0}) {
    const weather::Air air = weather::standardAir(height);
    worst = std::max(
        worst, std::isfinite(air.densityKgM3) && air.densityKgM3 >= 0 && air.temperatureK > 0 ? 0.0 : 1.0);
  }
  EXPECT_TRUE(holds("X48", worst, atMost(0), "heights without air"));
  EXPECT_TRUE(holds("X49", apart(weather::standardAir(kNone).densityKgM3, 1.225), atMost(1e-4), "kg/m3"));
}

TEST(Stability, X50_aGustKeepsNoMoreThanItHad) {
  // Of a step of 1e30 s: Euler's 1 - V dt / L is -1e29.
  const weather::DrydenScales scales = weather::drydenScales(100, 10, 2);
  double worst = 0;
  for (const double speed : {0.0, 1e-30, 70.0, 1e30}) {
    for (const double dt : {0.0, 5e-324, 1e-30, 1.0, 1e30}) {
      const weather::DrydenStep step(scales, speed, dt);
      for (const double keep : {step.keepU, step.v.keep, step.w.keep})
        worst = std::max({worst, keep - 1, -keep});
      worst = std::max(worst, std::isfinite(step.noiseU + step.v.noise22 + step.v.noise21) ? 0.0 : 1.0);
    }
  }
  EXPECT_TRUE(holds("X50", worst, atMost(0), "beyond [0, 1]"));
}

TEST(Stability, X51_iceAfterAnyTimeIsAShare) {
  double worst = 0;
  for (const double seconds : {0.0, 5e-324, 1.0, 1e30}) {
    for (const double temperature : {-1e30, -7.0, -0.0, 1e30}) {
      const double ice = weather::iceAfter(0.5, {temperature, 1, 10}, 10, seconds);
      worst = std::max({worst, ice - 1, -ice});
    }
  }
  EXPECT_TRUE(holds("X51", worst, atMost(0), "beyond [0, 1]"));
}

TEST(Stability, X54_aCameraThatIsNoneIsRefused) {
  render::Camera camera;
  camera.setPose({1, 2, 3}, 0, 0, 0);
  int refused = 0;
  for (const double bad : {kNone, kEndless, -kEndless}) {
    for (int i = 0; i < 4; ++i) {
      const auto pose = [&](int place) { return place == i ? bad : 0.5; };
      try {
        camera.setPose({pose(0), 0, 0}, pose(1), pose(2), pose(3));
      } catch (const core::RangeError&) {
        ++refused;
      }
    }
  }
  EXPECT_TRUE(holds("X54", refused, test::atLeast(12), "refusals of 12"));
  EXPECT_EQ(camera.position(), glm::dvec3(1, 2, 3));
}

TEST(Stability, X55_aStepIsDueWhenItIs) {
  // 1e6 frames of a hair less than a step: summed in float they would be 20 s off.
  float sum = 0;
  for (int i = 0; i < 1000000; ++i) sum += 1.0f / 120;
  EXPECT_GT(apart(sum, 1e6 / 120), 15);
  core::FixedStep clock;
  int due = 0;
  for (int i = 0; i < 1000000; ++i) due += clock.advance(std::nextafter(1.0 / 120, 0));
  EXPECT_TRUE(holds("X55", apart(due, 1000000), atMost(1), "steps"));
}

}  // namespace
}  // namespace skydrop
