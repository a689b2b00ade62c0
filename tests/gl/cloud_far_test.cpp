// The far field of the clouds: no seam where it begins, and how far it is from what is marched with detail.
#include <algorithm>
#include <cmath>
#include <string>

#include "support/cloud_rows.h"
#include "support/shared_noise.h"

namespace skydrop::render {
namespace {

class CloudFarGLTest : public test::CloudRowsGLTest {
 protected:
  static constexpr int kWidth = 192, kHeight = 96;

  void SetUp() override {
    CloudRowsGLTest::SetUp();
    clouds_.march = test::rowsOf(clouds::CloudTier::high);
    settings_.camera.fovDegrees = 12;
  }
  // Over the layer, from 13 degrees below the horizon to 1: what a row shows is at one distance, about.
  View down(double yaw) const { return pose({0, 4600, 0}, yaw, -7, 0, kWidth, kHeight); }

  // Of the shown picture, a row each, from below.
  static std::vector<double> rowMeans(const std::vector<glm::vec4>& scene) {
    std::vector<double> means(kHeight);
    for (std::size_t i = 0; i < scene.size(); ++i) {
      const glm::vec3 light = shown(scene[i]) * 255.0f;
      means[i / kWidth] += static_cast<double>(light.x + light.y + light.z) / (3.0 * kWidth);
    }
    return means;
  }
};

TEST_F(CloudFarGLTest, noSeamWhereTheFarFieldBegins) {
  // From over the clouds, where rows tell the distance, through the air of the scene fair: the far field from
  // 24 km on against none, in the mean of six directions. From row to row that changes by less than rows do
  // by themselves.
  features_.haze = true;
  settings_.camera.fovDegrees = 20;
  addSky();
  addClouds(test::sharedNoise());
  std::vector<double> apart(kHeight, 0.0), mean(kHeight, 0.0);
  constexpr int kDirections = 6;
  for (int i = 0; i < kDirections; ++i) {
    const View view = down(i * 60);
    clouds_.march.farStartM = 24000;
    const std::vector<double> with = rowMeans(sceneFrom(view));
    clouds_.march.farStartM = 60000;
    const std::vector<double> without = rowMeans(sceneFrom(view));
    for (std::size_t y = 0; y < with.size(); ++y) {
      apart[y] += (with[y] - without[y]) / kDirections;
      mean[y] += without[y] / kDirections;
    }
  }
  const auto steepest = [](const std::vector<double>& rows) {
    double most = 0;
    for (std::size_t y = 1; y < rows.size(); ++y) most = std::max(most, std::abs(rows[y] - rows[y - 1]));
    return most;
  };
  double most = 0;
  for (const double row : apart) most = std::max(most, std::abs(row));
  RecordProperty("mostApart", std::to_string(most));
  RecordProperty("steepestApart", std::to_string(steepest(apart)));
  RecordProperty("steepestRows", std::to_string(steepest(mean)));
  EXPECT_GT(most, 0.01) << "there is no far field";
  EXPECT_LT(most, 3);
  EXPECT_LT(steepest(apart), 0.8);
  EXPECT_LT(steepest(apart), steepest(mean));
}

TEST_F(CloudFarGLTest, aMediumWithoutDetailIsTheSameFarAndNear) {
  // Where the density is the profile alone there is nothing to leave out: with the far field and without,
  // within 2 of 255.
  addSky();
  addClouds(test::plainNoise());
  clouds_.layers[0].coverage = 1;
  clouds_.layers[0].erosion = 0;
  clouds_.layers[0].extinction = 1e-4;
  for (const View& view : {down(40), pose({0, 900, 0}, 40, 3, 0, kWidth, kHeight)}) {
    clouds_.march.farStartM = 24000;
    const std::vector<glm::vec4> with = sceneFrom(view);
    clouds_.march.farStartM = 60000;
    EXPECT_LT(difference(with, sceneFrom(view)), 2);
  }
}

TEST_F(CloudFarGLTest, cloudsReachTheHorizon) {
  // In a closed layer from 600 m below its base: half a degree over the horizon little comes through where
  // clouds end at 60 km (its base there is .3 degrees high), and all of it where they end at 24 km.
  settings_.camera.fovDegrees = 0.6;
  addClouds(test::plainNoise());
  clouds_.layers[0].coverage = 1;
  const View view = pose({0, clouds_.layers[0].cloudHeight - 600, 0}, 40, 0.8, 0, 32, 32);
  EXPECT_GT(meanOpacity(cloudsFrom(view)), 0.99);
  clouds_.fadeDistance = 24000;
  sceneFrom(view);
  EXPECT_EQ(system_->skipReason(gameFrame(snapshot_, view, features_)), "the layer is out of view");
}

}  // namespace
}  // namespace skydrop::render
