// Lightning in frames of the scene `thunderstorm`: what a flash lights, when nothing of it is drawn or
// compiled, and that no texel overflows.
#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <string>
#include <vector>

#include "app/settings/settings.h"
#include "skydrop/render/lightning/lightning_pass.h"
#include "support/light_probe.h"
#include "support/margin.h"
#include "support/scene_gl_test.h"

namespace skydrop::app {
namespace {

using Light = std::vector<glm::vec4>;

constexpr Size kSize{160, 90};

double luminanceOf(const glm::vec4& texel) {
  return 0.2126 * static_cast<double>(texel.x) + 0.7152 * static_cast<double>(texel.y) +
         0.0722 * static_cast<double>(texel.z);
}

class LightningGLTest : public test::SceneGLTest {
 protected:
  void begin(const std::vector<std::string>& set = {}) {
    beginScene(lineOf("thunderstorm",
                      {"render.land.detail=plain", "streaming.viewDistanceM=8000", "effects.clouds=false",
                       "effects.precipitation=false", "effects.sound=false", "lightning.groundShare=1",
                       "render.sun.elevationDegrees=-9"},
                      set));
    sceneRenderer_->renderer().add(std::make_unique<test::LightProbe>(light_));
    snapshot_ = simulation_->world().now();
    sceneRenderer_->camera().setMode(render::CameraMode::free);
    flash_ = weather::flashesBetween(snapshot_.weather, run_->settings.lightning, 0, 3600, {}).front();
    lookFrom({-2500, 150, 0});
  }

  // From a place relative to the foot of the flash, along +x.
  void lookFrom(const glm::dvec3& aside, double pitchDegrees = 0) {
    const glm::dvec3 foot(flash_.to.x, simulation_->ground()->sample({flash_.to.x, flash_.to.z}).height,
                          flash_.to.z);
    sceneRenderer_->camera().setPose(foot + aside, 0, glm::radians(pitchDegrees), 0);
  }
  const Light& frameAt(double seconds) {
    snapshot_.simulatedSeconds = snapshot_.weather.seconds = seconds;
    sceneRenderer_->draw(snapshot_, kSize, Streaming::settled);
    return light_;
  }
  const Light& before() { return frameAt(flash_.seconds - 0.01); }
  const Light& within() { return frameAt(flash_.seconds + 0.02); }
  core::PassStatistics statisticsOf(const std::string& pass) {
    core::FrameStatistics statistics;
    sceneRenderer_->renderer().fillStatistics(statistics);
    for (const auto& [name, row] : statistics.passes)
      if (name == pass) return row;
    ADD_FAILURE() << "no pass " << pass;
    return {};
  }
  static double meanOf(const Light& light, int firstRow, int endRow) {
    double sum = 0;
    for (int i = firstRow * kSize.width; i < endRow * kSize.width; ++i)
      sum += luminanceOf(light[static_cast<std::size_t>(i)]);
    return sum / ((endRow - firstRow) * kSize.width);
  }

  game::Snapshot snapshot_;
  weather::Flash flash_;
  Light light_;
};

TEST_F(LightningGLTest, aFlashLightsTheLandAndTheAircraftAndIsOut) {
  // The land in the lower fifth at least twice as bright as before, and as before when the flash is out.
  begin();
  const Light dark = before(), lit = within(), after = frameAt(flash_.seconds + 1.4);
  const double landBefore = meanOf(dark, 0, kSize.height / 5), landLit = meanOf(lit, 0, kSize.height / 5);
  EXPECT_GT(landLit, 2 * landBefore);
  EXPECT_NEAR(meanOf(after, 0, kSize.height / 5), landBefore, 0.02 * landBefore);
  // The aircraft before the eye, with the flash behind it.
  snapshot_.aircraft.position = sceneRenderer_->view(snapshot_, kSize).position + glm::dvec3(12, -1, 0);
  lookFrom({2500, 150, 0});
  snapshot_.aircraft.position = sceneRenderer_->view(snapshot_, kSize).position + glm::dvec3(12, -1, 0);
  const auto middle = [](const Light& light) {
    return luminanceOf(
        light[static_cast<std::size_t>(kSize.width * (kSize.height / 2 - 4) + kSize.width / 2)]);
  };
  const double aircraftBefore = middle(before()), aircraftLit = middle(within());
  EXPECT_GT(aircraftLit, 1.5 * aircraftBefore);
}

TEST_F(LightningGLTest, betweenFlashesNothingIsDrawnAndTheReasonSaysSo) {
  begin();
  before();
  for (const char* pass : {"lightningLight", "lightning"}) {
    EXPECT_EQ(statisticsOf(pass).skipped, "no flash at this moment") << pass;
    EXPECT_EQ(statisticsOf(pass).draws, 0) << pass;
  }
  within();
  EXPECT_EQ(statisticsOf("lightning").skipped, "");
  EXPECT_EQ(statisticsOf("lightning").draws, 2);
}

TEST_F(LightningGLTest, nothingIsCompiledWhenAFlashComes) {
  // After the frames to warm up with, the frames before, in and after a flash ask for as many other programs
  // as those of the same scene without lightning do, and the flash itself for none.
  const auto programs = [&] { return context().resources().live(render::gl::ObjectKind::program); };
  const auto askedAfterWarmUp = [&] {
    sceneRenderer_->warmUp(snapshot_, kSize);
    const std::int64_t warm = programs();
    before();
    return programs() - warm;
  };
  begin({"effects.lightning=false"});
  const std::int64_t withoutLightning = askedAfterWarmUp();
  sceneRenderer_.reset();
  begin();
  EXPECT_EQ(askedAfterWarmUp(), withoutLightning);
  const std::int64_t dark = programs();
  within();
  EXPECT_EQ(programs(), dark);
  frameAt(flash_.seconds + 1.4);
  EXPECT_EQ(programs(), dark);
}

TEST_F(LightningGLTest, exposureKnowsNoFlash) {
  // What eyes adapt to is the same before the flash and in it; so what no light of it reaches is unchanged.
  begin();
  before();
  const double level = sceneRenderer_->renderer().lightInView();
  within();
  EXPECT_EQ(sceneRenderer_->renderer().lightInView(), level);
}

TEST_F(LightningGLTest, softnessHoldsTheBrightestFrameDown) {
  begin();
  const auto brightest = [&] {
    double most = 0;
    for (int i = 0; i < 30; ++i)
      most = std::max(most, meanOf(frameAt(flash_.seconds + 0.02 * i), 0, kSize.height / 5));
    return most;
  };
  const double dark = meanOf(before(), 0, kSize.height / 5), hard = brightest();
  core::setField(run_->table, "lightning.softness=1");
  sceneRenderer_->apply({"lightning"});
  EXPECT_LT(brightest() - dark, 0.6 * (hard - dark));
}

TEST_F(LightningGLTest, W50_noTexelOverflowsBeforeTheSunOrInTheDarkestNight) {
  // The channel across the sun's disc at noon; and the darkest night's exposure; at the highest brightness.
  test::noFaults("W50", "violations");
  for (const char* elevation : {"-30", "-9", "1", "30"}) {
    begin({"lightning.brightness=4", std::string("render.sun.elevationDegrees=") + elevation,
           "render.sun.azimuthDegrees=90"});
    for (const double aside : {-800.0, -20.0, -20000.0}) {
      for (const double pitch : {0.0, 30.0}) {
        lookFrom({aside, 150, 0}, pitch);
        for (const glm::vec4& texel : within())
          ASSERT_TRUE(std::isfinite(texel.x + texel.y + texel.z)) << elevation << ' ' << aside;
      }
    }
  }
}

TEST_F(LightningGLTest, W53_theEyeMayStandInTheChannel) {
  test::noFaults("W53", "violations");
  begin();
  const weather::Channel channel = weather::channelOf(flash_, 0);
  for (const glm::dvec3& place :
       {channel.lights[0], channel.lights[7], channel.pieces[20].from, channel.pieces.back().to}) {
    for (const double pitch : {-89.0, 0.0, 89.0}) {
      sceneRenderer_->camera().setPose(place, 0, glm::radians(pitch), 0);
      for (const glm::vec4& texel : within()) ASSERT_TRUE(std::isfinite(texel.x + texel.y + texel.z));
    }
  }
}

TEST_F(LightningGLTest, W54_timeMayRunBackwardsStandStillAndJump) {
  // The same picture at the same time to the bit, whatever was drawn before it.
  test::noFaults("W54", "violations");
  begin();
  const Light first = within();
  frameAt(flash_.seconds + 0.2);
  frameAt(flash_.seconds - 86400);
  frameAt(flash_.seconds + 86400);
  const Light again = within(), held = within();
  ASSERT_EQ(first.size(), again.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    ASSERT_EQ(first[i], again[i]) << i;
    ASSERT_EQ(first[i], held[i]) << i;
  }
}

}  // namespace
}  // namespace skydrop::app
