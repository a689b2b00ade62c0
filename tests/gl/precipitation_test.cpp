// Rain and snow in frames: where there is none, what streaks and veil look like, their rows, and their hard
// cases.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <string>
#include <vector>

#include "app/settings/settings.h"
#include "skydrop/core/assets.h"
#include "skydrop/core/hash.h"
#include "skydrop/core/shared_precipitation.h"
#include "skydrop/render/models/aircraft_pass.h"
#include "skydrop/render/models/model_import.h"
#include "skydrop/render/precipitation/precipitation_pass.h"
#include "skydrop/render/precipitation/rain_veil_pass.h"
#include "skydrop/render/precipitation/splash_pass.h"
#include "skydrop/render/precipitation/wet_ground_pass.h"
#include "skydrop/render/sky/rainbow_pass.h"
#include "skydrop/weather/fall.h"
#include "support/margin.h"
#include "support/plains_test.h"
#include "support/row_steps.h"

namespace skydrop::render {
namespace {

using Light = std::vector<glm::vec4>;
namespace shared = core::shared::f64;

constexpr int kWidth = 96, kHeight = 54;

class PrecipitationGLTest : public test::PlainsTest {
 protected:
  void SetUp() override {
    PlainsTest::SetUp();
    if (IsSkipped()) return;
    veil_ = add<RainVeilPass>(rows_);
    drops_ = add<PrecipitationPass>(rows_);
    splashes_ = add<SplashPass>(rows_);
    site().layers[0] = {.genus = weather::Genus::nimbostratus, .base = 1500, .top = 4000, .cover = 1};
    weather_.variability = 0;
    snapshot_.simulatedSeconds = 100;
  }
  weather::SiteSettings& site() { return weather_.sites[0]; }
  View small(double height, double yaw, double pitch) const {
    return pose({0, height, 0}, yaw, pitch, 0, kWidth, kHeight);
  }
  FrameInput input(const View& view) {
    snapshot_.weather = {.settings = std::make_shared<weather::WeatherSettings>(weather_),
                         .seed = 1,
                         .seconds = snapshot_.simulatedSeconds};
    veil_->apply(rows_);
    drops_->apply(rows_);
    splashes_->apply(rows_);
    FrameInput frame = gameFrame(snapshot_, view, features_);
    frame.eyeVelocity = eyeVelocity_;
    return frame;
  }
  Light frame(const View& view) {
    draw(input(view));
    return light_;
  }
  // Of the streaks alone: the mean share of the light that they take from a white world, and how many pixels
  // they touch.
  struct Covered {
    double mean = 0;
    int pixels = 0;
    bool isFinite = true;
  };
  Covered covered(const View& view) {
    plains_ = {{0, glm::vec3(0.2f)}};
    const PrecipitationSettings kept = rows_;
    const Light with = frame(view);
    rows_.drops = 0;
    const Light without = frame(view);
    rows_ = kept;
    Covered result;
    for (std::size_t i = 0; i < with.size(); ++i) {
      const double change = std::abs(static_cast<double>(with[i].y - without[i].y));
      result.mean += change / static_cast<double>(with.size());
      result.pixels += change > 0;
      result.isFinite &= std::isfinite(with[i].x + with[i].y + with[i].z);
    }
    return result;
  }
  // What streaks take of the light of what is behind them, as the change of the difference of a white and a
  // black world.
  double shareTaken(const View& view) {
    const PrecipitationSettings kept = rows_;
    double taken = 0, behind = 0;
    for (const bool hasDrops : {true, false}) {
      rows_.drops = hasDrops ? kept.drops : 0;
      plains_ = {{0, glm::vec3(1)}};
      const Light white = frame(view);
      plains_ = {{0, glm::vec3(0)}};
      const Light black = frame(view);
      for (std::size_t i = 0; i < white.size(); ++i)
        (hasDrops ? taken : behind) += static_cast<double>(white[i].y - black[i].y);
    }
    rows_ = kept;
    return 1 - taken / behind;
  }
  // The same of all drops between the eye and where half of them have faded, 400 m up.
  double allTaken() {
    const double rate = weather::fallAt(weather::stateOf(site()), 400).rain;
    return 1 - std::exp(-shared::rainExtinction(rate) * 0.8 * rows_.rangeM);
  }
  void expectFinite(const View& view, const std::string& what) {
    for (const glm::vec4& texel : frame(view)) {
      ASSERT_TRUE(std::isfinite(texel.x + texel.y + texel.z)) << what;
      ASSERT_GE(std::min({texel.x, texel.y, texel.z}), 0) << what;
      ASSERT_LE(std::max({texel.x, texel.y, texel.z}), 65504) << what;
    }
  }

  PrecipitationSettings rows_;
  weather::WeatherSettings weather_;
  glm::dvec3 eyeVelocity_{0};
  RainVeilPass* veil_ = nullptr;
  PrecipitationPass* drops_ = nullptr;
  SplashPass* splashes_ = nullptr;
};

TEST_F(PrecipitationGLTest, W43_W45_nothingIsDrawnWhereNothingFalls) {
  // 0 mm/h, no cloud, above the cloud: a reason, and the frame without, to the bit. 150 mm/h is drawn.
  test::noFaults("W43 W45", "violations");
  const View view = small(400, 40, 5);
  const Light dry = frame(view);
  EXPECT_EQ(drops_->skipReason(input(view)), "it is dry");
  EXPECT_EQ(veil_->skipReason(input(view)), "it is dry");
  EXPECT_EQ(splashes_->skipReason(input(small(5, 0, 0))), "it is dry");
  site().rain = 150;
  EXPECT_EQ(drops_->skipReason(input(view)), std::nullopt);
  expectFinite(view, "150 mm/h");
  EXPECT_NE(frame(view), dry);
  EXPECT_EQ(drops_->skipReason(input(small(4000, 0, 0))), "above the cloud that feeds it");
  EXPECT_EQ(drops_->skipReason(input(small(9000, 0, 0))), "above the cloud that feeds it");
  EXPECT_EQ(drops_->skipReason(input(small(3900, 0, 0))), std::nullopt);
  EXPECT_EQ(veil_->skipReason(input(small(4100, 0, 60))), "the view lies above the cloud that feeds it");
  EXPECT_EQ(veil_->skipReason(input(small(4100, 0, 0))), std::nullopt);
  EXPECT_EQ(splashes_->skipReason(input(small(30, 0, 0))), "the sea is too far below");
  site().layers[0].cover = 0;
  EXPECT_EQ(drops_->skipReason(input(view)), "no cloud that it could fall from");
  EXPECT_EQ(frame(view), dry);
}

TEST_F(PrecipitationGLTest, theVeilTakesWhatTheFormulaSays) {
  // The contrast of a plain below, as the difference of a white and a black one, in level rain without
  // streaks: exp(-extinction distance) within 0.03 from a few hundred metres to kilometres, at the corners of
  // the grid's spans and between.
  rows_.drops = 0;
  rows_.veilSteps = 64;
  features_.haze = false;
  site().rain = 5;
  site().layers[0].base = 3000;
  site().temperature = 40;  // no snow below the base
  int tried = 0;
  const View view = small(200, 30, -12);
  plains_ = {{0, glm::vec3(1)}};
  const Light white = frame(view);
  plains_ = {{0, glm::vec3(0)}};
  const Light black = frame(view);
  site().rain = 0;
  const Light blackDry = frame(view);
  plains_ = {{0, glm::vec3(1)}};
  const Light whiteDry = frame(view);
  site().rain = 5;
  const weather::State state = weather::stateOf(site());
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const glm::dvec3 ray = rayDirection(view, {x + 0.5, y + 0.5});
      const double length = 200 / -ray.y;
      if (ray.y >= 0 || length > 2000) continue;
      double depth = 0;
      for (int i = 0; i < 200; ++i) {
        const double height = 200 + ray.y * length * (i + 0.5) / 200;
        depth += shared::rainExtinction(weather::fallAt(state, height).rain) * length / 200;
      }
      const auto i = static_cast<std::size_t>(y * kWidth + x);
      const double through = static_cast<double>((white[i].y - black[i].y) / (whiteDry[i].y - blackDry[i].y));
      EXPECT_NEAR(through, std::exp(-depth), 0.03) << length;
      ++tried;
    }
  }
  EXPECT_GT(tried, 1000);
}

TEST_F(PrecipitationGLTest, streaksTakeAShareOfWhatAllDropsWouldThatGrowsWithTheirNumber) {
  // The light that streaks take of a plain below, against that of all drops between the eye and where half of
  // them have faded: no more than it, and nearer to it the more there are.
  features_.haze = false;
  site().rain = 10;
  site().temperature = 40;
  rows_.shutterS = 0.005;
  const double all = allTaken();
  double before = 0;
  const View down = pose({0, 400, 0}, 0, -60, 0, 320, 180);
  const auto msOfFrame = [&] {  // the quickest of some: the machine has other work
    double least = 1e9;
    for (int i = 0; i < 12; ++i) {
      const auto begin = std::chrono::steady_clock::now();
      frame(down);
      const auto passed = std::chrono::steady_clock::now() - begin;
      least = std::min(least, std::chrono::duration<double, std::milli>(passed).count());
    }
    return least;
  };
  rows_.drops = 0;
  const double without = msOfFrame();
  for (const double drops : {300.0, 2400.0, 12000.0}) {
    rows_.drops = drops;
    const double share = shareTaken(down) / all;
    // Error against time: of the light that all drops together take, by the formula that the veil has.
    std::printf(
        "%.0f drops: %.3f of what all would take, an error of %.3f, in frames of %.1f ms (%.1f without)\n",
        drops, share, std::abs(share - 1), msOfFrame(), without);
    EXPECT_GT(share, before);
    EXPECT_LT(share, 1.3);
    before = share;
  }
}

TEST_F(PrecipitationGLTest, W40_streaksAtRestAndAt300MetresASecond) {
  // Finite, and seen; longer streaks are fainter: they never take more than all drops would, at rest and at
  // 70 and 300 m/s.
  site().rain = 10;
  site().temperature = 40;
  const double all = allTaken();
  for (const double speed : {0.0, 70.0, 300.0}) {
    eyeVelocity_ = {0, 0, -speed};
    const Covered streaks = covered(small(400, 0, 0));
    EXPECT_TRUE(streaks.isFinite);
    EXPECT_GT(streaks.pixels, 50) << speed;
    const double share = shareTaken(pose({0, 400, 0}, 0, -30, 0, 320, 180));
    EXPECT_GT(share, 0) << speed;
    EXPECT_TRUE(test::holds("W40", share, test::below(1.1 * all), "of the light")) << speed;
  }
}

TEST_F(PrecipitationGLTest, W41_W42_rainIsThereABillionMetresOutAndAfterAMonth) {
  // As many streaks as at the origin, within a third; two frames of one moment are equal to the bit.
  site().rain = 10;
  const Covered here = covered(small(400, 0, 0));
  const View out = pose({1e9, 400, -1e9}, 0, 0, 0, kWidth, kHeight);
  const Covered there = covered(out);
  EXPECT_TRUE(there.isFinite);
  EXPECT_TRUE(test::holds("W41", test::apart(there.mean / here.mean, 1), test::atMost(0.34), "relative"));
  snapshot_.simulatedSeconds = 2592000.5;
  const Covered late = covered(small(400, 0, 0));
  EXPECT_TRUE(late.isFinite);
  EXPECT_TRUE(test::holds("W42", test::apart(late.mean / here.mean, 1), test::atMost(0.34), "relative"));
  EXPECT_EQ(frame(out), frame(out));
  const Light before = frame(out);
  snapshot_.simulatedSeconds += 1.0 / 120;
  EXPECT_NE(frame(out), before) << "it falls";
}

TEST_F(PrecipitationGLTest, W44_noneIsInsideTheCabin) {
  // From the pilot's seat: what the cockpit shows is the same with and without streaks; what is seen through
  // the windows is not.
  test::noFaults("W44", "violations");
  snapshot_.aircraft.present = true;
  snapshot_.aircraft.position = {0, 400, 0};
  const auto model = std::make_shared<const Model>(
      context(), importModel(core::assetPath("models/airplane.glb")), "airplane");
  renderer().add(std::make_unique<AircraftPass>(model));
  rows_.rangeM = 6;
  rows_.drops = 12000;
  site().rain = 100;
  Camera camera;
  camera.setMode(CameraMode::cockpit);
  const View view = camera.view(snapshot_, settings_.camera, 320, 180);
  const Light with = frame(view);
  // The veil between the eye and the panel is thinner than a step of half floats; streaks are what differs.
  rows_.drops = 0;
  const Light without = frame(view);
  int inside = 0, outside = 0;
  for (int y = 0; y < 180; ++y) {
    for (int x = 0; x < 320; ++x) {
      const auto i = static_cast<std::size_t>(y * 320 + x);
      // The panel fills the lower quarter; the side windows reach beside it.
      const bool isPanel = y < 45 && x >= 60 && x < 260;
      if (with[i] != without[i]) (isPanel ? inside : outside) += 1;
    }
  }
  EXPECT_EQ(inside, 0);
  EXPECT_GT(outside, 500);
}

TEST_F(PrecipitationGLTest, W46_lightIsWithinTheFormatInEveryDirection) {
  // Into the sun, up and down, at its rise, with drops and flakes of all kinds near the eye: finite, not
  // negative, within half floats.
  test::noFaults("W46", "violations");
  site().rain = 150;
  site().snow = 20;
  site().sleet = 50;
  site().hail = 100;
  plains_ = {{0, glm::vec3(0.2f)}};
  for (const double elevation : {-3.0, 0.0, 1.0, 60.0}) {
    settings_.sun.elevationDegrees = elevation;
    settings_.sun.azimuthDegrees = 90;
    for (const double pitch : {-90.0, 0.0, elevation, 90.0})
      expectFinite(small(100, 0, pitch), std::to_string(elevation) + " " + std::to_string(pitch));
  }
}

TEST_F(PrecipitationGLTest, W47_theVeilFromEveryHeight) {
  // Level rays and those straight up and down, with the eye below the sea, on it, on the base and the top of
  // the cloud and a hair beside, and 80 km up.
  test::noFaults("W47", "violations");
  site().rain = 8;
  for (const bool haze : {true, false}) {
    features_.haze = haze;
    for (const double height : {-50.0, 0.0, 1499.999, 1500.0, 3999.999, 4000.0, 4000.001, 80000.0}) {
      for (const double pitch : {-90.0, 0.0, 90.0})
        expectFinite(small(height, 40, pitch), std::to_string(height));
    }
  }
}

TEST_F(PrecipitationGLTest, W49_aShareOfThePictureIsThatShareOfIt) {
  // The streaks of a part of the picture are those of the whole: a pixel differs by rounding at their edges.
  site().rain = 20;
  rows_.veilColumns = 160;
  const View whole = pose({0, 400, 0}, 40, 5, 0, 128, 128);
  const Light all = frame(whole);
  const Light part = frame(partOf(whole, {64, 32}, 64, 1));
  int differ = 0;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const glm::vec4 a = all[static_cast<std::size_t>((y + 32) * 128 + x + 64)],
                      b = part[static_cast<std::size_t>(y * 64 + x)];
      differ += std::abs(a.y - b.y) > 0.02f * std::max(a.y, 0.01f);
    }
  }
  EXPECT_TRUE(test::holds("W49", differ, test::below(20), "pixels"));
}

TEST_F(PrecipitationGLTest, theRainbowFollowsTheRainOfTheWeather) {
  // By hand without weather; with it there is one where it rains opposite the sun, and none where it is dry
  // or snows.
  const RainbowPass rainbow(context(), {});
  const auto reason = [&](bool hasWeather) {
    FrameInput frame = input(small(400, 180, 10));
    frame.toSun = {0.8, 0.6, 0};
    frame.sunSine = 0.6;
    if (!hasWeather) snapshot_.weather = {};
    return rainbow.skipReason(frame);
  };
  EXPECT_EQ(reason(false), std::nullopt);
  EXPECT_EQ(reason(true), "no rain");
  site().rain = 5;
  EXPECT_EQ(reason(true), std::nullopt);
  site().temperature = -10;
  EXPECT_EQ(reason(true), "no rain");
}

TEST_F(PrecipitationGLTest, everyTenthOfEveryRowMakesADifference) {
  // In what an eye sees of rain a few metres above the sea, and in whether land is told that it is wet.
  plains_ = {{0, glm::vec3(0.2f)}};
  site().rain = 20;
  app::Settings settings;
  const core::SettingsTable table(settings);
  const auto observe = [&] {
    rows_ = settings.precipitation;
    core::StateHasher h;
    for (const double pitch : {2.0, -30.0}) {
      for (const glm::vec4& texel : frame(pose({0, 4, 0}, 40, pitch, 0, 192, 108)))
        for (int c = 0; c < 3; ++c) h.add(static_cast<double>(texel[c]));
    }
    h.add(static_cast<std::uint64_t>(WetGroundPass(rows_).skipReason(input(small(4, 40, 2))).has_value()));
    return h.value();
  };
  EXPECT_EQ(test::expectNoIdleSteps(table, {"precipitation."}, observe), 8);
}

}  // namespace
}  // namespace skydrop::render
