// Ground fog in frames: against the formula in double, its light, its rows, and when it is left out.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "app/settings/settings.h"
#include "skydrop/core/hash.h"
#include "skydrop/core/shared.h"
#include "skydrop/render/fog/ground_fog_pass.h"
#include "support/plains_test.h"
#include "support/row_steps.h"

namespace skydrop::render {
namespace {

using Light = std::vector<glm::vec4>;
namespace shared = core::shared::f64;

constexpr int kWidth = 64, kHeight = 36;

class GroundFogGLTest : public test::PlainsTest {
 protected:
  void SetUp() override {
    PlainsTest::SetUp();
    if (IsSkipped()) return;
    pass_ = add<GroundFogPass>(fog_);
  }
  View small(double height, double yaw, double pitch) const {
    return pose({0, height, 0}, yaw, pitch, 0, kWidth, kHeight);
  }
  Light frame(const View& view) {
    pass_->apply(fog_);
    draw(view);
    return light_;
  }
  std::optional<std::string> reason(const View& view) {
    pass_->apply(fog_);
    return pass_->skipReason(gameFrame(snapshot_, view, features_));
  }
  // Of the fog alone, before exposure: an eye in dense fog.
  glm::dvec3 fogLight(double yaw, double elevation) {
    settings_.sun.elevationDegrees = elevation;
    fog_ = {.density = 0.2, .baseM = 5000, .scaleHeightM = 40};
    const glm::vec4 texel = frame(small(100, yaw, 0))[kHeight / 2 * kWidth + kWidth / 2];
    return glm::dvec3(texel) / skyLight(settings_, 100).exposure;
  }

  GroundFogSettings fog_;
  GroundFogPass* pass_ = nullptr;
};

TEST_F(GroundFogGLTest, transmittanceIsThatOfTheFormulaInDouble) {
  // What comes through from a plain at sea level, as the difference of a white and a black one, in each pixel
  // that sees it: within 2e-3, four roundings to half floats. From within the fog, above it, and from 1e6 m;
  // with its base above the plain and below it.
  features_.haze = false;
  fog_ = {.density = 0.01, .baseM = 100, .scaleHeightM = 60};
  int tried = 0;
  double least = 1, most = 0;
  for (const auto& [baseM, view] : {std::pair{100.0, small(30, 40, -5)},
                                    {100.0, small(150, 200, -20)},
                                    {-40.0, small(150, 200, -20)},
                                    {-40.0, small(3000, 10, -60)},
                                    {100.0, small(1e6, 0, -90)}}) {
    fog_.baseM = baseM;
    plains_ = {{0, glm::vec3(1)}};
    const Light white = frame(view);
    plains_ = {{0, glm::vec3(0)}};
    const Light black = frame(view);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const glm::dvec3 ray = rayDirection(view, {x + 0.5, y + 0.5});
        const double length = view.position.y / -ray.y;
        if (ray.y >= 0 || length * std::sqrt(1 - ray.y * ray.y) > 1.9e5) continue;
        const double path =
            shared::groundFogPath(view.position.y - fog_.baseM, -view.position.y, length, fog_.scaleHeightM);
        const auto i = static_cast<std::size_t>(y * kWidth + x);
        const double through = static_cast<double>(white[i].x - black[i].x);
        EXPECT_NEAR(through, std::exp(-fog_.density * path), 2e-3) << view.position.y << ' ' << x << ' ' << y;
        least = std::min(least, through), most = std::max(most, through);
        ++tried;
      }
    }
  }
  EXPECT_GT(tried, 3000);
  EXPECT_LT(least, 0.01);
  EXPECT_GT(most, 0.15);
}

TEST_F(GroundFogGLTest, framesAreFiniteAtAnyHeightAndInAnyDirection) {
  // From 100 m below the base to 1e6 m above it, with haze and without, sky and land in view.
  plains_ = {{0, glm::vec3(0.2f)}};
  for (const bool haze : {true, false}) {
    features_.haze = haze;
    for (const double height : {2.0, 60.0, 5000.0, 1e6}) {
      for (const double pitch : {-90.0, -10.0, 0.0, 90.0}) {
        for (const glm::vec4& texel : frame(small(height, 40, pitch)))
          ASSERT_TRUE(std::isfinite(texel.x + texel.y + texel.z)) << height << ' ' << pitch;
      }
    }
  }
}

TEST_F(GroundFogGLTest, sunAndSkyLightIt) {
  // Towards a low sun brighter and redder than away from it; dimmer than at noon; after sunset at most a
  // hundredth of the day's, and not black.
  features_.haze = false;
  settings_.sun.azimuthDegrees = 90;
  const glm::dvec3 noon = fogLight(180, 50), towards = fogLight(0, 3), away = fogLight(180, 3),
                   night = fogLight(180, -8);
  EXPECT_GT(towards.x, 1.2 * away.x);
  EXPECT_GT(towards.x / towards.z, 1.2 * away.x / away.z);
  EXPECT_LT(away.y, noon.y / 3);
  EXPECT_LT(night.y, noon.y / 100);
  EXPECT_GT(night.y, 0);
}

TEST_F(GroundFogGLTest, fogFarAwayMeetsTheHazyHorizonWithoutASeam) {
  // From above the fog, with haze: across the horizon the light changes by at most 2 % from one row of
  // pixels to the next, a 36th of a degree. (Without its haze the fog would end in a line.)
  features_.haze = true;
  plains_ = {{0, glm::vec3(0.05f)}};
  fog_ = {.density = 0.01, .baseM = 60, .scaleHeightM = 40};
  constexpr int kRows = 2160;
  const Light light = frame(pose({0, 600, 0}, 180, 0, 0, kWidth, kRows));
  for (int y = kRows / 2 - 4; y < kRows / 2 + 4; ++y) {
    const auto at = [&](int row) { return light[static_cast<std::size_t>(row * kWidth + kWidth / 2)].y; };
    EXPECT_NEAR(at(y) / at(y + 1), 1, 0.02) << y;
  }
}

TEST_F(GroundFogGLTest, whatCannotTouchTheFrameSaysWhy) {
  // No density; and wherever a reason is given, no ray of 60 views that rise by less and less meets an
  // optical depth of more than 1e-5, while the others do.
  fog_.density = 0;
  EXPECT_EQ(reason(small(10, 0, 0)), "no density");
  fog_.density = 0.01;
  EXPECT_EQ(reason(small(10, 0, 80)), std::nullopt);
  EXPECT_EQ(reason(small(1e6, 0, -10)), std::nullopt);
  int left = 0, drawn = 0;
  for (int i = 0; i < 60; ++i) {
    const View view = pose({0, 600, 0}, 7.0 * i, 75 - i, 3.0 * (i % 10), kWidth, kHeight);
    double most = 0;
    for (int y = 0; y <= kHeight; ++y) {
      for (int x = 0; x <= kWidth; ++x) {
        const double rise = rayDirection(view, {x * 1.0, y * 1.0}).y;
        const double above = std::exp(-(600 - fog_.baseM) / fog_.scaleHeightM);
        most = std::max(most, rise > 0 ? fog_.density * fog_.scaleHeightM * above / rise : 1);
      }
    }
    const std::optional<std::string> why = reason(view);
    (why ? left : drawn) += 1;
    EXPECT_EQ(why.value_or(""), most < 1e-5 ? "the view lies above the fog" : "") << i;
  }
  EXPECT_GT(left, 10);
  EXPECT_GT(drawn, 10);
}

TEST_F(GroundFogGLTest, everyTenthOfEveryRowMakesADifference) {
  // In what an eye sees of sky and land from 300 m.
  plains_ = {{0, glm::vec3(0.2f)}};
  app::Settings settings;
  const core::SettingsTable table(settings);
  const auto observe = [&] {
    fog_ = settings.groundFog;
    core::StateHasher h;
    for (const double pitch : {2.0, -40.0}) {
      for (const glm::vec4& texel : frame(small(300, 40, pitch)))
        for (int c = 0; c < 3; ++c) h.add(static_cast<double>(texel[c]));
    }
    return h.value();
  };
  EXPECT_EQ(test::expectNoIdleSteps(table, {"groundFog."}, observe), 3);
}

}  // namespace
}  // namespace skydrop::render
