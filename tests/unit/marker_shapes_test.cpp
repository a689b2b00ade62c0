// The shapes of a target's mark (shaders/shared/marker.glsl) in C++.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "skydrop/core/hash.h"
#include "skydrop/core/shared.h"

namespace skydrop::core::shared {
namespace {

double depthAlong(const glm::dvec3& direction, const glm::dvec3& foot, double radius) {
  const glm::dvec2 t = f64::beamInterval(direction, foot, radius);
  return t.y > t.x ? f64::beamOpticalDepth(direction, foot, radius, t.x, t.y) : 0;
}

TEST(MarkerShapes, ringKeepsItsWidthInPixelsOfAnySize) {
  // The shares of a row of pixels add up to the ring's width, wherever the pixels' borders lie; no share is
  // above 1, and a pixel wider than the ring shows it as much fainter as it is wider. Rounding only: 1e-9.
  for (const double footprint : {0.013, 0.5, 3.9, 4.1, 17.0}) {
    for (const double shift : {0.0, 0.3, 0.9}) {
      double width = 0;
      for (double d = 60 + shift * footprint; d < 140; d += footprint) {
        const double share = f64::ringCoverage(d, 100, footprint);
        ASSERT_GE(share, 0);
        ASSERT_LE(share, std::min(1.0, f64::kRingWidth / footprint) + 1e-12);
        width += share * footprint;
      }
      EXPECT_NEAR(width, f64::kRingWidth, 1e-9) << footprint;
    }
  }
  EXPECT_EQ(f32::ringCoverage(100, 100, 0), 1.0f);
  EXPECT_EQ(f32::ringCoverage(105, 100, 0), 0.0f);
  EXPECT_EQ(f32::ringCoverage(1e6f, 100, 1e6f), 0.0f);
}

TEST(MarkerShapes, ringLiesOnLandNearTheFootOnly) {
  // Full up to three quarters of its reach of two radii above or below the foot, nothing from there on.
  EXPECT_EQ(f64::ringFade(0, 100), 1);
  EXPECT_EQ(f64::ringFade(-150, 100), 1);
  EXPECT_NEAR(f64::ringFade(175, 100), 0.5, 1e-12);
  EXPECT_EQ(f64::ringFade(200, 100), 0);
  EXPECT_EQ(f64::ringFade(-4000, 100), 0);
}

TEST(MarkerShapes, beamFadesToNothingOnAllSides) {
  // Densest on the axis a third of the way up, where it is 1; 0 at foot, top, radius and beyond.
  EXPECT_NEAR(f64::beamDensity({0, f64::kBeamHeight / 3, 0}, 4), 1, 1e-12);
  for (const glm::dvec3 place :
       {glm::dvec3(0, 0, 0), {0, f64::kBeamHeight, 0}, {4, 100, 0}, {0, 100, -9}, {0, -5, 0}, {0, 900, 0}}) {
    EXPECT_EQ(f64::beamDensity(place, 4), 0);
  }
}

TEST(MarkerShapes, beamIsAtLeastTwoPixelsWide) {
  // Near it is a few metres wide; from 6 km, with 1.6 mrad a pixel (720 rows), its density is half or
  // more across two pixels.
  EXPECT_EQ(f64::beamRadius(100, 1.6e-3), f64::kBeamRadius);
  const double radius = f64::beamRadius(6000, 1.6e-3);
  EXPECT_GE(f64::beamDensity({1.6e-3 * 6000, f64::kBeamHeight / 3, 0}, radius), 0.5);
}

TEST(MarkerShapes, intervalHoldsExactlyTheBeam) {
  // Against 20 001 points along each of 2000 rays, one in ten of them level, one upright and one nearly
  // upright: a point is inside the interval if and only if it is inside the beam, but for 1e-6 m at its ends.
  RandomStream random{11, 0};
  int inside = 0;
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 foot(random.nextUnit() * 60 - 30, random.nextUnit() * 700 - 600,
                          random.nextUnit() * 8 - 4);
    glm::dvec3 direction(random.nextUnit() * 2 - 1, random.nextUnit() * 2 - 1, random.nextUnit() * 0.2 - 0.1);
    if (i % 10 == 0) direction.y = 0;
    if (i % 10 == 1) direction = {0, direction.y, 0};
    if (i % 10 == 2) direction = {direction.x * 2e-3, direction.y > 0 ? 1 : -1, direction.z * 2e-3};
    direction = glm::normalize(direction);
    const glm::dvec2 t = f64::beamInterval(direction, foot, 5);
    ASSERT_GE(t.x, 0);
    for (int step = 0; step <= 20000; ++step) {
      const double distance = step * 0.05;
      const glm::dvec3 place = direction * distance - foot;
      if (std::abs(distance - t.x) < 1e-6 || std::abs(distance - t.y) < 1e-6) continue;
      const double edge = std::min(
          {25 - place.x * place.x - place.z * place.z, place.y * 10, (f64::kBeamHeight - place.y) * 10});
      if (std::abs(edge) < 1e-4) continue;  // along a border
      ASSERT_EQ(edge > 0, distance > t.x && distance < t.y) << i << " " << distance;
      inside += edge > 0;
    }
  }
  EXPECT_GT(inside, 10000);
}

TEST(MarkerShapes, opticalDepthIsTheIntegral) {
  // Four points are exact for the density's polynomial: against 100 000 midpoints (their error is 1e-9), also
  // when the way ends inside the beam.
  RandomStream random{12, 0};
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 foot(20 + random.nextUnit() * 900, random.nextUnit() * 700 - 600, 0);
    const glm::dvec3 direction =
        glm::normalize(foot + glm::dvec3(0, random.nextUnit() * f64::kBeamHeight, random.nextUnit() * 8 - 4));
    glm::dvec2 t = f64::beamInterval(direction, foot, 4);
    if (t.y <= t.x) continue;
    t.y = t.x + (t.y - t.x) * (0.3 + 0.7 * random.nextUnit());
    constexpr int kSteps = 100000;
    double sum = 0;
    for (int step = 0; step < kSteps; ++step) {
      sum += f64::beamDensityAt(direction, foot, 4, t.x + (t.y - t.x) * (step + 0.5) / kSteps);
    }
    sum *= f64::kBeamDepth * (t.y - t.x) / kSteps / (4 * 16.0 / 15.0);
    ASSERT_NEAR(f64::beamOpticalDepth(direction, foot, 4, t.x, t.y), sum, 1e-8 + 1e-8 * sum);
  }
}

TEST(MarkerShapes, levelBeamIsAsDeepAsItIsCalled) {
  // Straight through the densest place the optical depth is kBeamDepth, for a beam of any width.
  const double third = f64::kBeamHeight / 3;
  for (const double radius : {4.0, 18.0, 300.0}) {
    EXPECT_NEAR(depthAlong({1, 0, 0}, {5000, -third, 0}, radius), f64::kBeamDepth, 1e-12);
  }
  EXPECT_EQ(f64::beamOpacity(0), 0);
  EXPECT_EQ(f64::beamOpacity(1e9), f64::kBeamOpacity);
}

TEST(MarkerShapes, raysAlongTheBeamAreNoSpecialCase) {
  // Straight down the axis, and tilted by so little that another branch is taken, from above, from inside and
  // from below: depths agree within 1e-3 relative (a tilt of 2e-6 strays 2 mm of 4 m over 1 km). A level ray
  // equals one that is nearly level.
  for (const double eyeAbove : {900.0, 300.0, 0.5}) {
    const glm::dvec3 foot(1, -eyeAbove, 1);
    const double straight = depthAlong({0, -1, 0}, foot, 4);
    EXPECT_GT(straight, 1e-6);
    for (const double tilt : {0.9e-6, 1.1e-6, 2e-6}) {
      EXPECT_NEAR(depthAlong(glm::normalize(glm::dvec3(tilt, -1, 0)), foot, 4) / straight, 1, 1e-3);
    }
  }
  EXPECT_GT(depthAlong({0, 1, 0}, {0, 100, 0}, 4), 10);
  EXPECT_EQ(depthAlong({0, 1, 0}, {0, -900, 0}, 4), 0);
  EXPECT_EQ(depthAlong({0, -1, 0}, {4.01, -900, 0}, 4), 0);
  const double level = depthAlong({1, 0, 0}, {50, -200, 0}, 4);
  EXPECT_NEAR(depthAlong(glm::normalize(glm::dvec3(1, 2e-9, 0)), {50, -200, 0}, 4), level, 1e-6);
  EXPECT_EQ(depthAlong({1, 0, 0}, {50, 1, 0}, 4), 0);
  EXPECT_EQ(depthAlong({1, 0, 0}, {-50, -200, 0}, 4), 0);
}

TEST(MarkerShapes, floatEqualsDouble) {
  // Rays past beams up to 10 km away, eyes in the beam among them: opacity within 2e-3. (At 10 km a float ray
  // is off by 1 mm, against a radius that is 25 m there, and 4 m near by.)
  RandomStream random{13, 0};
  for (int i = 0; i < 100000; ++i) {
    const double distance = std::pow(random.nextUnit(), 4) * 1e4;
    const double radius = f64::beamRadius(distance, 1e-3);
    const glm::vec3 foot(static_cast<float>(distance), static_cast<float>(random.nextUnit() * 700 - 600),
                         0.0f);
    const glm::vec3 direction = glm::normalize(
        foot + glm::vec3(0, random.nextUnit() * 500, (random.nextUnit() * 3 - 1.5) * radius) + 1e-3f);
    const glm::vec2 t = f32::beamInterval(direction, foot, static_cast<float>(radius));
    const float depth =
        t.y > t.x ? f32::beamOpticalDepth(direction, foot, static_cast<float>(radius), t.x, t.y) : 0.0f;
    const double exact = depthAlong(glm::normalize(glm::dvec3(direction)), glm::dvec3(foot), radius);
    ASSERT_NEAR(static_cast<double>(f32::beamOpacity(depth)), f64::beamOpacity(exact), 2e-3) << i;
  }
}

}  // namespace
}  // namespace skydrop::core::shared
