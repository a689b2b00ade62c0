// The ways of what is thrown up, the waves of what falls into water, and what a burst is made of.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "render/spray/burst_clouds.h"
#include "skydrop/core/hash.h"
#include "skydrop/core/shared_spray.h"
#include "support/margin.h"

namespace skydrop::render {
namespace {

namespace f32 = core::shared::f32;
namespace f64 = core::shared::f64;
using game::BurstKind;
using game::SurfaceBurst;

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

SurfaceBurst burstOf(BurstKind kind, bool onWater) {
  SurfaceBurst burst;
  burst.number = 7;
  burst.kind = kind;
  burst.velocity = {28, -8, 3};
  burst.wind = {4, 0, -2};
  burst.onWater = onWater;
  burst.ground = {0.8, {0.3, 0.25, 0.2}};
  return burst;
}

constexpr BurstKind kKinds[] = {BurstKind::package,  BurstKind::touchDown, BurstKind::rolling,
                                BurstKind::ditching, BurstKind::swimming,  BurstKind::crash,
                                BurstKind::sliding};

// dv/dt = -drag (v - wind) - fall y, in 4000 steps of Runge and Kutta of the fourth order; place and
// velocity.
std::pair<glm::dvec3, glm::dvec3> flown(const glm::dvec3& velocity, const glm::dvec3& wind, double drag,
                                        double fall, double seconds) {
  const auto pull = [&](const glm::dvec3& v) { return -drag * (v - wind) - glm::dvec3(0, fall, 0); };
  glm::dvec3 place(0), v = velocity;
  const double h = seconds / 4000;
  for (int i = 0; i < 4000; ++i) {
    const glm::dvec3 a = pull(v), b = pull(v + a * (h / 2)), c = pull(v + b * (h / 2)), d = pull(v + c * h);
    place += v * h + (a + b + c) * (h * h / 6);
    v += (a + b * 2.0 + c * 2.0 + d) * (h / 6);
  }
  return {place, v};
}

TEST(Spray, U02_waysAreTheSolutionAtAnyDragAndTime) {
  // Against integration in 4000 steps, from no drag to such that stops at once: within 1e-6 of the way in
  // double, for the series are good to 2e-7. In float within 1e-5 of it.
  core::RandomStream random{11, 0};
  const auto in = [&](double low, double high) { return low + (high - low) * random.nextUnit(); };
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 velocity(in(-30, 30), in(-5, 30), in(-30, 30)), wind(in(-9, 9), 0, in(-9, 9));
    const double drag = i % 10 == 0 ? 0 : i % 10 == 1 ? 1e-9 : std::exp(in(-6, 3));
    const double fall = in(-2, 10), seconds = in(0, 12);
    const auto [place, v] = flown(velocity, wind, drag, fall, seconds);
    const glm::dvec3 way = f64::sprayWay(velocity, wind, drag, fall, seconds);
    const double scale = 1 + glm::length(velocity) * seconds + fall * seconds * seconds;
    EXPECT_TRUE(test::holds("U02", glm::distance(way, place) / scale, test::below(1e-6), "of the way"))
        << drag;
    EXPECT_LT(glm::distance(f64::sprayVelocity(velocity, wind, drag, fall, seconds), v), 1e-5) << drag;
    const auto f = [](double value) { return static_cast<float>(value); };
    const glm::dvec3 coarse(
        f32::sprayWay(glm::vec3(velocity), glm::vec3(wind), f(drag), f(fall), f(seconds)));
    EXPECT_LT(glm::distance(coarse, way) / scale, 1e-5) << drag;
  }
}

TEST(Spray, impactWavesRunOutwardsAndCalm) {
  // Crests move outwards at the phase speed sqrt(g / k) of their wave number, and the group falls behind; all
  // is calm at the first moment, in the middle and far ahead.
  const double radius = 0.7;
  const auto slope = [&](double r, double t) { return f64::impactWaveSlope(r, t, radius); };
  EXPECT_EQ(slope(5, 0), 0);
  EXPECT_LT(std::abs(slope(200, 4)), 1e-4);
  EXPECT_LT(std::abs(slope(0, 4)), 1e-4);
  // The outermost zero of the slope after t: phase pi.
  const auto front = [&](double t) { return f64::kGravityMps2 * t * t / (4 * 3.14159265358979); };
  for (const double t : {2.0, 4.0, 6.0}) {
    EXPECT_LT(std::abs(slope(front(t), t)), 1e-6);
    const double k = f64::kGravityMps2 * t * t / (4 * front(t) * front(t));
    const double speed = (front(t + 1e-4) - front(t - 1e-4)) / 2e-4;
    EXPECT_NEAR(speed, std::sqrt(f64::kGravityMps2 / k), 1e-3 * speed);
  }
  const auto steepest = [&](double t) {
    double most = 0;
    for (double r = 0.2; r < 60; r += 0.01) most = std::max(most, std::abs(slope(r, t)));
    return most;
  };
  EXPECT_GT(steepest(2), 1.7 * steepest(4));
  EXPECT_GT(steepest(4), 1.7 * steepest(8));
}

TEST(Spray, everyKindShowsSomethingAndEnds) {
  // On its surface each kind has clouds soon after, finite, within the reach that they state, and none before
  // it happened or after kBurstSeconds.
  for (const BurstKind kind : kKinds) {
    for (const bool onWater : {false, true}) {
      const bool isDry = kind == BurstKind::touchDown || kind == BurstKind::rolling;
      const bool isWet = kind == BurstKind::ditching || kind == BurstKind::swimming;
      if ((isDry && onWater) || (isWet && !onWater)) continue;
      const SurfaceBurst burst = burstOf(kind, onWater);
      EXPECT_FALSE(cloudsOf(burst, 0.4, 1).empty()) << static_cast<int>(kind);
      EXPECT_TRUE(cloudsOf(burst, -0.01, 1).empty());
      EXPECT_TRUE(cloudsOf(burst, game::kBurstSeconds + 0.01, 1).empty());
      EXPECT_TRUE(cloudsOf(burst, 0.4, 0).empty());
      EXPECT_EQ(wakeOf(burst, 1, 1).has_value(), onWater);
      for (const double age : {0.0, 0.3, 1.0, 3.0, 8.0}) {
        for (const BurstCloud& cloud : cloudsOf(burst, age, 1)) {
          const double t = std::min(cloud.age, cloud.lifeSeconds);
          for (const glm::dvec3& thrown : {glm::dvec3(cloud.outMps, 0, 0), glm::dvec3(0, cloud.upMps, 0),
                                           glm::dvec3(0, 0, -cloud.outMps)}) {
            const glm::dvec3 way =
                f64::sprayWay(cloud.carried + thrown, cloud.wind, cloud.drag, cloud.fall, t);
            EXPECT_LT(glm::length(way), cloud.reachM) << static_cast<int>(kind) << " " << age;
          }
        }
      }
    }
  }
}

TEST(Spray, U03_whatIsNoNumberIsNotDrawn) {
  // A burst of which any number is none, and one whose surface has no normal: no cloud, and a finite one.
  test::noFaults("U03", "clouds of what is no number");
  for (const BurstKind kind : kKinds) {
    for (const bool onWater : {false, true}) {
      for (int which = 0; which < 7; ++which) {
        SurfaceBurst burst = burstOf(kind, onWater);
        if (which == 0) burst.position.x = kNotANumber;
        if (which == 1) burst.velocity.y = kNotANumber;
        if (which == 2) burst.normal.z = std::numeric_limits<double>::infinity();
        if (which == 3) burst.wind.x = kNotANumber;
        if (which == 4) burst.seconds = kNotANumber;
        if (which == 5) burst.ground.albedo.y = kNotANumber;
        if (which == 6) burst.ground.looseness = kNotANumber;
        EXPECT_TRUE(cloudsOf(burst, 0.4, 1).empty()) << which;
        EXPECT_FALSE(wakeOf(burst, 0.4, 1)) << which;
      }
      EXPECT_TRUE(cloudsOf(burstOf(kind, onWater), kNotANumber, 1).empty());
      EXPECT_TRUE(cloudsOf(burstOf(kind, onWater), 0.4, kNotANumber).empty());
      SurfaceBurst flat = burstOf(kind, onWater);
      flat.normal = flat.velocity = glm::dvec3(0);
      for (const BurstCloud& cloud : cloudsOf(flat, 0.4, 1)) {
        EXPECT_EQ(cloud.up, glm::dvec3(0, 1, 0));
        EXPECT_TRUE(std::isfinite(cloud.reachM));
      }
    }
  }
}

}  // namespace
}  // namespace skydrop::render
