// Clouds without thickness on the processor: the curve from noise to opacity, the meshes, where textures lie.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "skydrop/core/shared.h"
#include "skydrop/render/clouds/cloud_plane.h"
#include "skydrop/render/clouds/cloud_plane_mesh.h"
#include "skydrop/render/clouds/sheet_noise.h"

namespace skydrop::render {
namespace {

namespace f32 = core::shared::f32;
namespace f64 = core::shared::f64;

// As the source has it.
double clampedAndExponentiated(double noise, double cutoff, double density) {
  return noise <= cutoff ? 0 : 1 - std::pow(density, 255 * (noise - cutoff));
}

TEST(CloudSheet, opacityIsTheClampedAndExponentiatedNoise) {
  // Against the formula with pow: within 1e-6 in double (the step's series), 1e-5 in float.
  for (const double density : {0.85, 0.95, 0.96, 0.99}) {
    for (const double cutoff : {0.0, 0.3, 0.6, 0.8}) {
      const double k = f64::sheetDepthPerNoise(density);
      for (double noise = 0; noise <= 1; noise += 0.01) {
        const double exact = clampedAndExponentiated(noise, cutoff, density);
        EXPECT_NEAR(f64::sheetOpacity(noise, cutoff, k), exact, 1e-6) << density << ' ' << noise;
        EXPECT_NEAR(f32::sheetOpacity(static_cast<float>(noise), static_cast<float>(cutoff),
                                      f32::sheetDepthPerNoise(static_cast<float>(density))),
                    exact, 1e-5)
            << density << ' ' << noise;
      }
    }
  }
}

TEST(CloudSheet, aPixelWithoutSpreadSeesTheCurveItself) {
  // Within 2e-3: the least spread is 1e-4, a 40th of a step of eight bits.
  const double k = f64::sheetDepthPerNoise(0.95);
  for (double noise = 0; noise <= 1; noise += 0.001) {
    EXPECT_NEAR(f64::sheetCoverOpacity(f64::sheetCover(noise, 0, 0.6, k), 1),
                clampedAndExponentiated(noise, 0.6, 0.95), 2e-3)
        << noise;
  }
}

TEST(CloudSheet, aWidePixelSeesTheMeanOfTheCurve) {
  // Against the mean of the curve over normally distributed noise: within 0.05 of the range; without the
  // spread clouds below the cutoff would be 0, off by 0.37.
  const double k = f64::sheetDepthPerNoise(0.95);
  double worst = 0, worstWithout = 0;
  for (const double spread : {0.02, 0.06, 0.12}) {
    for (double noise = 0.3; noise <= 0.9; noise += 0.02) {
      double sum = 0, weights = 0;
      for (double x = -5; x <= 5; x += 0.01) {
        const double weight = std::exp(-x * x / 2);
        sum += weight * clampedAndExponentiated(noise + spread * x, 0.6, 0.95);
        weights += weight;
      }
      const double seen = f64::sheetCoverOpacity(f64::sheetCover(noise, spread, 0.6, k), 1);
      worst = std::max(worst, std::abs(seen - sum / weights));
      worstWithout =
          std::max(worstWithout, std::abs(clampedAndExponentiated(noise, 0.6, 0.95) - sum / weights));
    }
  }
  RecordProperty("worst", std::to_string(worst));
  RecordProperty("worstWithout", std::to_string(worstWithout));
  EXPECT_LT(worst, 0.05);
  EXPECT_GT(worstWithout, 0.2);
}

TEST(CloudSheet, coverStaysFiniteForAnyNoise) {
  // From far below the cutoff to far above, any spread: share in [0, 1], depth finite and not negative.
  for (const float noise : {0.0f, 0.2f, 0.6f, 0.600001f, 1.0f}) {
    for (const float spread : {0.0f, 1e-6f, 0.05f, 1.0f}) {
      for (const float cutoff : {0.0f, 0.6f, 1.0f, 2.0f}) {
        const f32::SheetCover cover = f32::sheetCover(noise, spread, cutoff, 56.0f);
        EXPECT_TRUE(cover.share >= 0 && cover.share <= 1);
        EXPECT_TRUE(std::isfinite(cover.depth) && cover.depth >= 0);
      }
    }
  }
}

TEST(CloudSheet, lowerSheetsDriftFaster) {
  // As the source wants it, from the ground to 12 km.
  for (double height = 0; height < 12000; height += 100)
    EXPECT_GT(f64::sheetDriftShare(height), f64::sheetDriftShare(height + 100));
  EXPECT_DOUBLE_EQ(f64::sheetDriftShare(1000), 1);
}

TEST(CloudPlaneMesh, hasNineSegmentsASideAndFadesAtItsRimAlone) {
  // 10 x 10 vertices, corners at +-1, alpha 0 on the outermost ones and 1 on all others; triangles cover the
  // square once.
  const CloudPlaneMesh mesh = makeCloudPlaneMesh();
  ASSERT_EQ(mesh.vertices.size(), 100u);
  ASSERT_EQ(mesh.indices.size(), 9u * 9 * 6);
  for (const CloudPlaneVertex& vertex : mesh.vertices) {
    const bool isRim = std::max(std::abs(vertex.place.x), std::abs(vertex.place.y)) == 1;
    EXPECT_EQ(vertex.alpha, isRim ? 0.0f : 1.0f);
  }
  double area = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::vec2 a = mesh.vertices[mesh.indices[i]].place, b = mesh.vertices[mesh.indices[i + 1]].place,
                    c = mesh.vertices[mesh.indices[i + 2]].place;
    const double turn = static_cast<double>((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
    EXPECT_GT(std::abs(turn), 0);
    area += std::abs(turn);
  }
  EXPECT_NEAR(area, 4, 1e-5);
}

TEST(CloudPlaneMesh, rimFadesAsMuchInCornersAsOnSides) {
  // Alpha in the middle of a corner's segment is that in the middle of a side's: the diagonal runs inwards.
  const CloudPlaneMesh mesh = makeCloudPlaneMesh();
  const auto has = [&](int a, int b) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      const std::set<int> triangle = {mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]};
      if (triangle.contains(a) && triangle.contains(b)) return true;
    }
    return false;
  };
  EXPECT_TRUE(has(0, 11));
  EXPECT_TRUE(has(9, 18));
  EXPECT_TRUE(has(90, 81));
  EXPECT_TRUE(has(99, 88));
}

TEST(CloudPlane, placesKeepTheirTexel) {
  // The coordinate of a place in the world, seen from eyes a few metres apart, at the origin and at 1e12 m:
  // equal within the place's own rounding (1.2e-4 m there).
  const clouds::CloudPlaneSettings layer;
  const core::WindSettings wind;
  for (const double far : {0.0, 1e6, -1e9, 1e12}) {
    const glm::dvec3 eye(far, 500, -far / 3);
    const PlaneAnchor at = planeAnchor(layer, wind, eye, 1000);
    for (const double step : {1.0, 77.0, 4000.0}) {
      const glm::dvec3 moved = eye + glm::dvec3(step, 0, 2 * step);
      const PlaneAnchor there = planeAnchor(layer, wind, moved, 1000);
      const glm::dvec2 apart =
          there.texture - at.texture - glm::dvec2(moved.x - eye.x, moved.z - eye.z) / layer.period;
      const double tolerance = 3e-4 / layer.period + 1e-9;
      EXPECT_NEAR(std::remainder(apart.x, 1.0), 0, tolerance) << far << ' ' << step;
      EXPECT_NEAR(std::remainder(apart.y, 1.0), 0, tolerance) << far << ' ' << step;
      for (const double share : {there.texture.x, there.texture.y, there.weather.x, there.weather.y})
        EXPECT_TRUE(share >= 0 && share < 1);
    }
  }
}

TEST(CloudPlane, withoutWindNothingMoves) {
  // Any time, to the last bit.
  core::WindSettings wind;
  wind.speed = 0;
  const PlaneAnchor at = planeAnchor({}, wind, {1, 2, 3}, 0), later = planeAnchor({}, wind, {1, 2, 3}, 1e7);
  EXPECT_EQ(at.texture, later.texture);
  EXPECT_EQ(at.weather, later.weather);
}

TEST(CloudPlane, lowerLayersOvertakeHigherOnes) {
  // After 100 s in a wind of 8 m/s the layer at 900 m has drifted farther than that at 1400 m, by the share
  // of the wind that each takes.
  const core::WindSettings wind;
  const auto drifted = [&](double height) {
    clouds::CloudPlaneSettings layer;
    layer.height = height;
    const glm::dvec2 apart =
        planeAnchor(layer, wind, {0, 0, 0}, 0).texture - planeAnchor(layer, wind, {0, 0, 0}, 100).texture;
    return layer.period * std::hypot(std::remainder(apart.x, 1.0), std::remainder(apart.y, 1.0));
  };
  EXPECT_NEAR(drifted(900), 800 * 2 / 1.9, 1e-6);
  EXPECT_NEAR(drifted(1400), 800 * 2 / 2.4, 1e-6);
}

TEST(SheetNoise, levelsAreMeansAndSayWhatTheyLost) {
  // Each level's mean is the texture's; what is lost grows with the level, from nothing to the whole spread.
  clouds::CloudPlaneSettings settings;
  settings.textureSide = 128;
  const SheetNoise noise = makeSheetNoise(settings);
  ASSERT_EQ(noise.levels.size(), 8u);
  ASSERT_EQ(noise.lost.size(), 8u);
  for (const std::vector<float>& level : noise.levels) {
    double sum = 0;
    for (const float value : level) sum += static_cast<double>(value);
    EXPECT_NEAR(sum / static_cast<double>(level.size()), noise.mean, 1e-5);
  }
  EXPECT_NEAR(noise.lost.front(), 0, 1e-6);
  EXPECT_TRUE(std::ranges::is_sorted(noise.lost));
  EXPECT_NEAR(noise.lost.back(), noise.spread, 1e-6);
  EXPECT_GT(noise.spread, 0.02);
}

TEST(SheetNoise, whatWasStoppedIsEmpty) {
  // A stop before it begins gives no levels, and nothing is thrown.
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(makeSheetNoise(clouds::CloudPlaneSettings(), stop.get_token()).levels.empty());
}

}  // namespace
}  // namespace skydrop::render
