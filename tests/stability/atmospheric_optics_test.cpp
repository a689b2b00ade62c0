// Where halos and rainbows are hard: directions that coincide or are opposite, light in the zenith, at the
// horizon and in the nadir, level rays, eyes far up, below the sea and far out.
#include <gtest/gtest.h>

#include <cmath>

#include "skydrop/core/shared_optics.h"
#include "support/margin.h"

namespace skydrop::core::shared {
namespace {

glm::vec3 single(const glm::dvec3& v) { return glm::vec3(v); }

TEST(Stability, S60_angleFromTheLightIsRightNextToItAndOppositeToIt) {
  // In float, from 1e-6 radians up to as near to pi: within 1.2e-7 and a millionth of the angle that is
  // small, in any direction. (acos of the product reads 0 up to 2.4e-4, and 3.5e-4 next to it.)
  for (const glm::dvec3& light : {glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0), glm::dvec3(1, 0, 0),
                                  glm::normalize(glm::dvec3(0.3, 0.2, -0.9))}) {
    const glm::dvec3 aside = glm::normalize(glm::cross(light, glm::dvec3(0.2, 0.1, 0.7)));
    for (const double angle : {0.0, 1e-6, 1e-4, 1e-3, 0.38, 1.5, 3.0}) {
      const glm::dvec3 seen = std::cos(angle) * light + std::sin(angle) * aside;
      const double rounding = 1.2e-7 * 2;
      EXPECT_TRUE(test::holds(
          "S60", test::apart(static_cast<double>(f32::angleBetween(single(seen), single(light))), angle),
          test::atMost(rounding + 1e-6 * angle), "rad"));
      const double pi = 3.14159265358979;
      EXPECT_TRUE(test::holds(
          "S60",
          test::apart(static_cast<double>(f32::angleBetween(single(seen), single(-light))), pi - angle),
          test::atMost(rounding + 4e-7), "rad"));
    }
  }
}

TEST(Stability, S61_sunDogsHaveAPlaceForAnyLightAndAnyDirection) {
  // Light and view exactly in zenith, nadir and at the horizon, on each other and opposite: finite degrees;
  // elevations are those given; on the circle of the light's elevation the height above it is 0.
  const glm::vec3 directions[] = {{0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {0.6f, 0.8f, 0}};
  for (const glm::vec3& light : directions) {
    for (const glm::vec3& seen : directions) {
      const glm::vec3 at = f32::sunDogDegrees(seen, light);
      EXPECT_TRUE(std::isfinite(at.x + at.y + at.z)) << light.x << light.y << ' ' << seen.x << seen.y;
      EXPECT_TRUE(test::holds("S61", test::apart(at.z, std::asin(light.y) / f32::kDegree),
                              test::atMost(1e-3f), "degrees"));
      EXPECT_TRUE(test::holds("S61", test::apart(at.y + at.z, std::asin(seen.y) / f32::kDegree),
                              test::atMost(1e-3f), "degrees"));
    }
    EXPECT_TRUE(std::isfinite(f32::leastSunDogAzimuth(light.y)));
  }
  EXPECT_TRUE(test::holds("S61", test::apart(f32::leastSunDogAzimuth(1) / f32::kDegree, 120),
                          test::atMost(1e-3f), "degrees"));
  EXPECT_TRUE(test::holds("S61", test::apart(f32::leastSunDogAzimuth(0) / f32::kDegree, 21.6f),
                          test::atMost(0.05f), "degrees"));
}

TEST(Stability, S62_iceAndRainAreFiniteFromAnyHeightAndOnLevelRays) {
  // Slants in [1, 1.2e3] from below the sea and from close under the ice; the part of a ray in rain lies on
  // the ray and in the rain, from -50 m to 80 km, level, upright and on the way to the ground; scattered
  // light is finite and not negative for any depth.
  for (const float above : {0.0f, 1.0f, 50.0f, 8000.0f, 8050.0f, 15000.0f}) {
    float last = 2e3f;
    for (const float sine : {0.0f, 1e-6f, 1e-3f, 0.1f, 0.7f, 1.0f}) {
      const float slant = f32::iceSlant(sine, above), down = f32::iceSlant(-sine, above);
      EXPECT_GE(slant, 1 - 1e-6f);
      EXPECT_LE(slant, last);
      EXPECT_EQ(slant, down);
      last = slant;
    }
  }
  EXPECT_NEAR(f32::iceSlant(0, 8000), 20, 0.1f);
  for (const float eye : {-50.0f, 0.0f, 1499.0f, 1500.0f, 1501.0f, 8e4f, 1e6f}) {
    for (const float slope : {-1.0f, -1e-3f, -1e-9f, 0.0f, 1e-9f, 1e-3f, 1.0f}) {
      for (const float end : {0.0f, 10.0f, 3000.0f, f32::kFarMarker}) {
        const glm::vec2 path = f32::rainPath(eye, slope, end, 500, 4000, 1500);
        ASSERT_TRUE(std::isfinite(path.x) && path.y >= 0 && path.y <= 3500)
            << eye << ' ' << slope << ' ' << end;
        if (path.y <= 0) continue;
        EXPECT_GE(path.x, 500);
        EXPECT_LE(path.x + path.y, std::min(end, 4000.0f) * (1 + 1e-6f));
        for (const float t : {path.x, path.x + path.y}) EXPECT_LE(eye + slope * t, 1500.02f + 1e-6f * eye);
      }
    }
  }
  for (const float depth : {0.0f, 1e-30f, 1e-6f, 1.0f, 100.0f, 1e30f}) {
    EXPECT_TRUE(f32::rainScattering(depth) >= 0 && f32::rainScattering(depth) <= 0.5f + 1e-6f) << depth;
    EXPECT_TRUE(f32::iceScattering(depth) >= 0 && f32::iceScattering(depth) <= 0.37f) << depth;
  }
  EXPECT_TRUE(test::holds("S62", test::apart(f32::rainScattering(1e-6f) / 1e-6f, 1), test::atMost(1e-5f),
                          "relative"));
}

TEST(AtmosphericOptics, rainPathIsThatOfStepsThroughTheRain) {
  // In double against 1e-4 of the way a step: within two steps.
  for (const double eye : {-20.0, 300.0, 1499.0, 2600.0}) {
    for (const double slope : {-0.9, -0.3, -0.01, 0.0, 0.01, 0.4, 1.0}) {
      for (const double end : {400.0, 2500.0, 9000.0}) {
        constexpr int kSteps = 10000;
        double inside = 0;
        for (int i = 0; i < kSteps; ++i) {
          const double t = end * (i + 0.5) / kSteps;
          if (t > 500 && t < 4000 && eye + slope * t < 1500) inside += end / kSteps;
        }
        EXPECT_NEAR(f64::rainPath(eye, slope, end, 500, 4000, 1500).y, inside, 2 * end / kSteps)
            << eye << ' ' << slope << ' ' << end;
      }
    }
  }
}

}  // namespace
}  // namespace skydrop::core::shared
