// Dark days: the air below an even deck has no sun, and exposure follows what the clouds leave of the light.
#include <cmath>
#include <numbers>

#include "skydrop/render/frame/sky_light.h"
#include "support/cloud_layers.h"
#include "support/shared_noise.h"

namespace skydrop::render {
namespace {

class OvercastGLTest : public test::CloudLayersGLTest {
 protected:
  void SetUp() override {
    test::CloudLayersGLTest::SetUp();
    if (IsSkipped()) return;
    features_.haze = true;
    features_.overcast = true;
    settings_.sun.elevationDegrees = 40;
    settings_.sun.azimuthDegrees = 0;  // towards north
  }
  Overcast overcastAt(double height) {
    return system_->overcast(gameFrame(snapshot_, small({0, height, 0}, 90, 0), features_));
  }
  // Light of 20 km of air before black land, towards a yaw.
  double airLight(double yaw) {
    plains_ = {{0, glm::vec3(0)}};
    const std::vector<glm::vec4> scene = sceneFrom(small({0, 300, 0}, yaw, -14));
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < scene.size(); ++i) {
      const std::size_t row = i / test::kCloudRowsWidth;
      if (row < 24 || row > 26) continue;  // a little below the horizon
      sum += static_cast<double>(scene[i].y), ++count;
    }
    return sum / count;
  }
  static constexpr weather::WeatherLayerSettings kDeck{weather::Genus::nimbostratus, 1200, 5500, 1, 1};
};

TEST_F(OvercastGLTest, airBelowADeckHasNoSunSide) {
  // In the open the haze towards the sun is much brighter than that away from it; below a whole deck both
  // sides are alike within 5 %, and no brighter than half of all directions at E / pi each.
  addSky();
  addPlains();
  addClouds(test::sharedNoise());
  setWeather({{weather::Genus::cumulus, 1555, 3355, 0, 1}, kDeck});
  const double towards = airLight(270), away = airLight(90);
  EXPECT_NEAR(towards / away, 1, 0.05);
  const Overcast overcast = overcastAt(300);
  EXPECT_GT(overcast.cover, 0.99);
  EXPECT_LT(overcast.left, 0.4);
  EXPECT_EQ(overcast.baseM, 1200);
  const SkyLight light = skyLight(settings_, 300, 0, std::nullopt, overcast);
  const double level = (light.sun.y * light.toSun.y + light.sky.y + light.ground.y) * light.exposure *
                       overcast.left / (2 * std::numbers::pi);
  EXPECT_LT(towards, 1.1 * level);
  EXPECT_GT(towards, 0.15 * level) << "black";
  features_.overcast = false;
  EXPECT_GT(airLight(270) / airLight(90), 1.3);
}

TEST_F(OvercastGLTest, aDarkDayIsExposedLikeADarkHour) {
  // Level times what is left; a surface is then shown at that to the power 1 - 0.82 of a fair day.
  addClouds(test::sharedNoise());
  setWeather({kDeck});
  const Overcast overcast = overcastAt(300);
  const SkyLight open = skyLight(settings_, 300), dark = skyLight(settings_, 300, 0, std::nullopt, overcast);
  const double left = overcast.light();
  EXPECT_NEAR(dark.level / open.level, left, 1e-9);
  EXPECT_NEAR(dark.exposure / open.exposure, std::pow(left, -0.82), 1e-9);
  const double shown = dark.exposure * left / open.exposure;
  EXPECT_LT(shown, 0.9) << "as bright as a fair day";
  EXPECT_GT(shown, 0.5) << "black";
  RecordProperty("shown", std::to_string(shown));
}

TEST_F(OvercastGLTest, aboveTheDeckAndUnderScatteredCloudsTheDayIsFair) {
  // And on the way up through it nothing jumps.
  addClouds(test::sharedNoise());
  setWeather({kDeck});
  EXPECT_EQ(overcastAt(5600).light(), 1);
  double before = overcastAt(1000).light();
  EXPECT_LT(before, 0.4);
  for (double height = 1050; height < 5700; height += 50) {
    const double now = overcastAt(height).light();
    EXPECT_GE(now, before - 1e-12) << height;
    EXPECT_LT(now - before, 0.04) << height;
    before = now;
  }
  weather::WeatherLayerSettings scattered = kCumulus;
  scattered.cover = 0.3;
  setWeather({scattered});
  EXPECT_GT(overcastAt(300).light(), 0.98);
}

}  // namespace
}  // namespace skydrop::render
