#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "app/settings/settings.h"
#include "skydrop/core/hash.h"
#include "skydrop/core/shared_optics.h"
#include "skydrop/render/frame/light_shares.h"
#include "skydrop/render/sky/halo_pass.h"
#include "skydrop/render/sky/rainbow_pass.h"
#include "support/margin.h"
#include "support/plains_test.h"
#include "support/row_steps.h"

namespace skydrop::render {
namespace {

using Light = std::vector<glm::vec4>;
namespace shared = core::shared::f64;

constexpr int kWidth = 96, kHeight = 54;

class AtmosphericOpticsGLTest : public test::PlainsTest {
 protected:
  void SetUp() override {
    PlainsTest::SetUp();
    if (IsSkipped()) return;
    haloPass_ = add<HaloPass>(halo_);
    rainbowPass_ = add<RainbowPass>(rainbow_);
    settings_.sun.azimuthDegrees = 90;  // towards yaw 0
    settings_.sun.elevationDegrees = 20;
  }
  View view(double height, double yaw, double pitch, double x = 0) const {
    return pose({x, height, 0}, yaw, pitch, 0, kWidth, kHeight);
  }
  Light frame(const View& view) {
    haloPass_->apply(halo_);
    rainbowPass_->apply(rainbow_);
    draw(view);
    return light_;
  }
  // What halo and rainbow add to a picture: it with them less it without.
  Light added(const View& view) {
    const Light with = frame(view);
    const HaloSettings halo = halo_;
    const RainbowSettings rainbow = rainbow_;
    halo_.opticalDepth = 0, rainbow_.extinction = 0;
    Light difference = frame(view);
    halo_ = halo, rainbow_ = rainbow;
    for (std::size_t i = 0; i < with.size(); ++i) difference[i] = with[i] - difference[i];
    return difference;
  }
  FrameInput input(const View& view) {
    haloPass_->apply(halo_);
    rainbowPass_->apply(rainbow_);
    FrameInput frame = gameFrame(snapshot_, view, features_);
    frame.toSun = skyLight(settings_, view.position.y).direct.toSun;
    frame.sunSine = frame.toSun.y;
    return frame;
  }
  static float brightest(const Light& light) {
    float most = 0;
    for (const glm::vec4& texel : light) most = std::max({most, texel.x, texel.y, texel.z});
    return most;
  }
  // Over all pixels, the angle from a direction (degrees) at which a channel's mean over rings of half a
  // degree is largest, between two angles.
  double brightestRing(const Light& light, const View& view, const glm::dvec3& direction, int channel,
                       double from, double to) {
    constexpr double kRing = 0.5;
    std::vector<double> sums(400), counts(400);
    for (int y = 0; y < view.height; ++y) {
      for (int x = 0; x < view.width; ++x) {
        const double angle =
            shared::angleBetween(rayDirection(view, {x + 0.5, y + 0.5}), direction) * 180 / std::numbers::pi;
        const auto ring = static_cast<std::size_t>(angle / kRing);
        sums[ring] += static_cast<double>(light[static_cast<std::size_t>(y * view.width + x)][channel]);
        counts[ring] += 1;
      }
    }
    double best = 0, most = 0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
      const double angle = (static_cast<double>(i) + 0.5) * kRing;
      if (counts[i] > 0 && angle > from && angle < to && sums[i] / counts[i] > most)
        most = sums[i] / counts[i], best = angle;
    }
    return best;
  }

  HaloSettings halo_{.plates = 0};
  RainbowSettings rainbow_;
  HaloPass* haloPass_ = nullptr;
  RainbowPass* rainbowPass_ = nullptr;
};

TEST_F(AtmosphericOpticsGLTest, ringsInThePictureHaveTheirRadii) {
  // Halo around the sun, both bows around the antisolar point, each within a ring of half a degree and a
  // pixel of a third of one; the primary at 41 to 42.2 degrees.
  const View towards = pose({0, 100, 0}, 0, 20, 0, 320, 180), away = pose({0, 100, 0}, 180, 10, 0, 320, 180);
  const glm::dvec3 sun = skyLight(settings_, 100).direct.toSun;
  EXPECT_NEAR(brightestRing(added(towards), towards, sun, 0, 10, 40), 22.0, 0.6);
  const Light bows = added(away);
  EXPECT_NEAR(brightestRing(bows, away, -sun, 0, 0, 46), 41.8, 0.6);
  EXPECT_NEAR(brightestRing(bows, away, -sun, 2, 38, 46), 40.9, 0.6);
  EXPECT_NEAR(brightestRing(bows, away, -sun, 0, 46, 60), 51.3, 0.6);
  EXPECT_NEAR(brightestRing(bows, away, -sun, 2, 46, 60), 53.0, 0.8);
}

// Tells how much of the light is left, and where it was asked.
class Shade final : public Pass, private LightAtPlaces {
 public:
  Shade(const double& share, std::vector<glm::dvec3>& asked) : share_(share), asked_(asked) {}
  std::string_view name() const override { return "shade"; }
  RenderStage stage() const override { return RenderStage::shadows; }
  void draw(FrameContext& context) override { context.resources.replace<LightAtPlaces>(*this); }

 private:
  LightShares at(const glm::dvec3& place) const override {
    asked_.push_back(place);
    return {share_, 1};
  }
  const double& share_;
  std::vector<glm::dvec3>& asked_;
};

TEST_F(AtmosphericOpticsGLTest, theBowIsDimmedByWhatDimsTheLightOnTheRain) {
  // With all of the light it is the picture in which nobody dims it, with a quarter of it a quarter, to half
  // floats. Asked are places in the rain.
  const View away = view(100, 180, 10);
  const Light open = added(away);
  double share = 1;
  std::vector<glm::dvec3> asked;
  renderer().add(std::make_unique<Shade>(share, asked));
  EXPECT_EQ(added(away), open);
  share = 0.25;
  const Light dimmed = added(away);
  const float most = brightest(open);
  ASSERT_GT(most, 0);
  for (std::size_t i = 0; i < open.size(); ++i)
    EXPECT_NEAR(dimmed[i].y, 0.25f * open[i].y, 0.01f * most) << i;
  ASSERT_FALSE(asked.empty());
  for (const glm::dvec3& place : asked) {
    const double distance = glm::distance(place, away.position);
    EXPECT_TRUE(distance > rainbow_.nearM && distance < rainbow_.farM) << distance;
    EXPECT_TRUE(place.y >= 0 && place.y <= rainbow_.topM) << place.y;
  }
}

TEST_F(AtmosphericOpticsGLTest, platesMakeSunDogsAtTheHeightOfTheSun) {
  // With level plates alone the brightest pixel lies within a degree of the sun's elevation, and at its
  // azimuth's distance within 1.5 degrees (pixels of a third of a degree; the disc's middle lies inside).
  halo_.plates = 1;
  const View sky = pose({0, 100, 0}, 0, 20, 0, 320, 180);
  const glm::dvec3 sun = skyLight(settings_, 100).direct.toSun;
  const Light light = added(sky);
  std::size_t best = 0;
  for (std::size_t i = 0; i < light.size(); ++i) {
    if (light[i].y > light[best].y) best = i;
  }
  const glm::dvec3 seen =
      rayDirection(sky, {static_cast<int>(best) % 320 + 0.5, static_cast<int>(best) / 320 + 0.5});
  const glm::dvec3 at = shared::sunDogDegrees(seen, sun);
  EXPECT_NEAR(at.x, 0.6, 1);
  EXPECT_NEAR(at.y, 0, 1);
}

TEST_F(AtmosphericOpticsGLTest, landHidesTheHaloAndLiesBehindTheRainbow) {
  // With a plain below the eye, pixels that show it have nothing of the halo; the rainbow is on it too, from
  // where the rain begins on.
  plains_ = {{0, glm::vec3(0.2f)}};
  features_.haze = false;
  const View low = view(300, 0, -40), away = view(300, 180, -35);
  settings_.sun.elevationDegrees = 5;
  for (const glm::vec4& texel : added(low)) ASSERT_EQ(texel.y, 0);
  rainbow_.nearM = 100;
  EXPECT_GT(brightest(added(away)), 0.01f);
  rainbow_.nearM = 3000;
  EXPECT_EQ(brightest(added(view(300, 180, -50))), 0);
}

TEST_F(AtmosphericOpticsGLTest, sunAbove43DegreesHasNoBowAboveTheHorizon) {
  // Pixels above the horizon have nothing but what is outside the bows: under a tenth of a bow's light.
  const View sky = view(2, 180, 30);
  settings_.sun.elevationDegrees = 12;
  const float bow = brightest(added(sky));
  settings_.sun.elevationDegrees = 54;
  EXPECT_LT(brightest(added(sky)), bow / 5);
  EXPECT_GT(bow, 0.005f);
}

TEST_F(AtmosphericOpticsGLTest, whatCannotTouchTheFrameSaysWhy) {
  // Each reason, and none where it is seen; wherever a reason is given, a picture drawn all the same gets
  // nothing.
  const auto halo = [&](const View& v) { return haloPass_->skipReason(input(v)).value_or(""); };
  const auto rainbow = [&](const View& v) { return rainbowPass_->skipReason(input(v)).value_or(""); };
  EXPECT_EQ(halo(view(100, 0, 20)), "");
  EXPECT_EQ(rainbow(view(100, 180, 0)), "");
  EXPECT_EQ(halo(view(100, 180, 0)), "the halo is out of view");
  EXPECT_EQ(halo(view(9000, 0, 20)), "the view is above the ice");
  EXPECT_EQ(rainbow(view(9000, 180, 60)), "the view is above the rain");
  EXPECT_EQ(rainbow(view(9000, 180, -20)), "");
  settings_.sun.elevationDegrees = -5;
  EXPECT_EQ(halo(view(100, 0, 20)), "the light is below the horizon");
  EXPECT_EQ(rainbow(view(100, 180, 0)), "the light is below the horizon");
  settings_.sun.elevationDegrees = 80;
  EXPECT_EQ(rainbow(view(100, 0, 89)), "the rainbow is out of view");
  halo_.opticalDepth = 0, rainbow_.farM = rainbow_.nearM;
  EXPECT_EQ(halo(view(100, 0, 20)), "no ice");
  EXPECT_EQ(rainbow(view(100, 180, 0)), "no rain");
}

TEST_F(AtmosphericOpticsGLTest, noReasonHidesAVisibleHaloOrBow) {
  // Of 120 views, those with a reason have no pixel within the reach of the tables.
  int left = 0;
  for (int i = 0; i < 120; ++i) {
    settings_.sun.elevationDegrees = 5 + i % 60;
    const View v = pose({0, 100, 0}, 7.0 * i, 60 - i, 3.0 * (i % 30), kWidth, kHeight);
    const FrameInput frame = input(v);
    double toSun = 180, toAntisun = 180;
    for (int y = 0; y <= kHeight; ++y) {
      for (int x = 0; x <= kWidth; ++x) {
        const double angle =
            shared::angleBetween(rayDirection(v, {x * 1.0, y * 1.0}), frame.toSun) * 180 / std::numbers::pi;
        toSun = std::min(toSun, angle), toAntisun = std::min(toAntisun, 180 - angle);
      }
    }
    if (haloPass_->skipReason(frame)) {
      EXPECT_GT(toSun, 64) << i;
      ++left;
    }
    if (rainbowPass_->skipReason(frame)) {
      EXPECT_GT(toAntisun, 90) << i;
      ++left;
    }
  }
  EXPECT_GT(left, 20);
}

TEST_F(AtmosphericOpticsGLTest, S63_framesAreFiniteWhereverLightAndEyeAre) {
  // Light in zenith, nadir, at and around the horizon; towards it and away from it; from 80 km, -50 m and 1e9
  // m; six stops over: finite and within the format.
  test::noFaults("S63", "values that are not finite");
  halo_ = {.opticalDepth = 1, .plates = 0.5, .heightM = 15000};
  rainbow_ = {.extinction = 0.01, .dropRadiusMm = 1, .nearM = 0, .farM = 50000, .topM = 10000};
  settings_.exposureStops = 6;
  for (const double elevation : {90.0, 60.5, 0.0, -0.2, -90.0}) {
    settings_.sun.elevationDegrees = elevation;
    for (const double height : {-50.0, 100.0, 80000.0}) {
      for (const double pitch : {elevation, -elevation}) {
        for (const double x : {0.0, 1e9}) {
          for (const glm::vec4& texel : frame(view(height, pitch == elevation ? 0 : 180, pitch, x)))
            ASSERT_TRUE(std::isfinite(texel.x + texel.y + texel.z) && texel.y >= 0)
                << elevation << ' ' << height << ' ' << pitch;
        }
      }
    }
  }
}

TEST_F(AtmosphericOpticsGLTest, S63_picturesFarOutAreThoseOfTheOrigin) {
  // 1e9 m out, bit for bit.
  test::noFaults("S63", "violations");
  halo_.plates = 0.3;
  for (const double yaw : {0.0, 180.0})
    EXPECT_TRUE(frame(view(300, yaw, 5)) == frame(view(300, yaw, 5, 1e9)));
}

TEST_F(AtmosphericOpticsGLTest, everyTenthOfEveryRowMakesADifference) {
  // In what an eye at 300 m sees towards the sun and away from it.
  app::Settings settings;
  const core::SettingsTable table(settings);
  settings_.sun.elevationDegrees = 15;
  const auto observe = [&] {
    halo_ = settings.halo;
    rainbow_ = settings.rainbow;
    core::StateHasher h;
    for (const double yaw : {0.0, 180.0}) {
      for (const glm::vec4& texel : frame(view(300, yaw, 15)))
        for (int c = 0; c < 3; ++c) h.add(static_cast<double>(texel[c]));
    }
    return h.value();
  };
  EXPECT_EQ(test::expectNoIdleSteps(table, {"halo.", "rainbow."}, observe), 8);
}

}  // namespace
}  // namespace skydrop::render
