// Dust and spray in frames: nothing without a burst, the same whenever it is drawn, far out as near by,
// within what half floats keep, and bounded.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "skydrop/core/hash.h"
#include "skydrop/render/spray/spray_pass.h"
#include "support/margin.h"
#include "support/row_steps.h"
#include "support/scene_gl_test.h"

namespace skydrop::app {
namespace {

using game::BurstKind;

constexpr Size kSize{160, 90};
constexpr double kDegree = std::numbers::pi / 180;
constexpr glm::dvec3 kOpenSea(4400, 0, 4300);

class DustAndSprayGLTest : public test::SceneGLTest {
 protected:
  void begin(std::vector<std::string> set = {}) {
    beginScene(lineOf("lagoon",
                      {"effects.clouds=false", "effects.targets=false", "effects.hud=false",
                       "effects.landShadows=false", "effects.waterDetail=false", "effects.dustAndSpray=true"},
                      set),
               1);
    snapshot_ = simulation_->world().now();
    snapshot_.aircraft.present = false;
    snapshot_.simulatedSeconds = 40;
    sceneRenderer_->camera().setMode(render::CameraMode::free);
  }
  // From so far west of a place, looking at it.
  void look(const glm::dvec3& at, double away, double above) {
    sceneRenderer_->camera().setPose({at.x - away, at.y + above, at.z}, 0,
                                     -std::atan2(above - 1.5, std::max(away, 1.0)), 0);
  }
  void happen(BurstKind kind, const glm::dvec3& at, double age, bool onWater, std::uint32_t number = 3) {
    game::SurfaceBurst burst;
    burst.number = number;
    burst.kind = kind;
    burst.seconds = snapshot_.simulatedSeconds - age;
    burst.position = at;
    burst.velocity = {0, -8, 20};
    burst.onWater = onWater;
    burst.ground = {0.8, {0.3, 0.25, 0.2}};
    snapshot_.bursts.push_back(burst);
  }
  core::Image frame() {
    sceneRenderer_->draw(snapshot_, kSize, Streaming::settled);
    return sceneRenderer_->renderer().readBack();
  }
  std::vector<float> light() {
    frame();
    return sceneRenderer_->renderer().readRadiance();
  }
  std::string reasonOf(std::string_view pass) {
    frame();
    core::FrameStatistics statistics;
    sceneRenderer_->writeTo(statistics);
    for (const auto& [name, row] : statistics.passes)
      if (name == pass) return row.skipped;
    return "absent";
  }
  // What the bursts do to the picture: sum of the changes of light.
  double change() {
    const std::vector<float> with = light();
    const auto kept = std::exchange(snapshot_.bursts, {});
    const std::vector<float> without = light();
    snapshot_.bursts = kept;
    double sum = 0;
    for (std::size_t i = 0; i < with.size(); ++i) sum += static_cast<double>(std::abs(with[i] - without[i]));
    return sum;
  }
  std::size_t particles() { return sceneRenderer_->renderer().find<render::SprayPass>()->particlesDrawn(); }

  game::Snapshot snapshot_;
};

TEST_F(DustAndSprayGLTest, withoutABurstNothingIsDrawn) {
  // Each pass says why, and the picture is that of a scene without the effect, bit for bit.
  begin();
  look(kOpenSea, 15, 4);
  const core::Image idle = frame();
  EXPECT_EQ(reasonOf("spray"), "nothing has touched land or water");
  EXPECT_EQ(reasonOf("wakes"), "nothing has touched water");
  happen(BurstKind::package, kOpenSea + glm::dvec3(-900, 0, 0), 0.5, true);
  EXPECT_EQ(reasonOf("spray"), "nothing that flies up is near and in view");
  EXPECT_EQ(reasonOf("wakes"), "no wake is near and in view");
  EXPECT_EQ(frame().rgba, idle.rgba);
  set("dustAndSpray.amount=0");
  EXPECT_EQ(reasonOf("spray"), "no amount");
  EXPECT_EQ(reasonOf("wakes"), "no amount");
  begin({"effects.dustAndSpray=false"});
  look(kOpenSea, 15, 4);
  EXPECT_EQ(frame().rgba, idle.rgba);
}

TEST_F(DustAndSprayGLTest, eachKindShowsAndIsTheSameWheneverItIsDrawn) {
  // Each kind changes the picture; the same moment is the same picture, whatever was drawn in between.
  begin();
  look(kOpenSea, 20, 5);
  const core::Image calm = frame();
  struct Kind {
    BurstKind kind;
    bool onWater;
  };
  for (const Kind& k : {Kind{BurstKind::package, true},
                        {BurstKind::package, false},
                        {BurstKind::touchDown, false},
                        {BurstKind::rolling, false},
                        {BurstKind::ditching, true},
                        {BurstKind::swimming, true},
                        {BurstKind::crash, true},
                        {BurstKind::crash, false},
                        {BurstKind::sliding, false}}) {
    snapshot_.bursts.clear();
    happen(k.kind, kOpenSea, 0.7, k.onWater);
    const core::Image first = frame();
    EXPECT_NE(first.rgba, calm.rgba) << static_cast<int>(k.kind) << k.onWater;
    snapshot_.simulatedSeconds = 40.4;
    EXPECT_NE(frame().rgba, first.rgba);
    snapshot_.simulatedSeconds = 40;
    EXPECT_EQ(frame().rgba, first.rgba) << static_cast<int>(k.kind) << k.onWater;
  }
}

TEST_F(DustAndSprayGLTest, ringsAndFoamLieOnTheSeaAlone) {
  // A package on water changes pixels below the horizon only once the drops have fallen.
  begin();
  look(kOpenSea, 20, 5);
  const core::Image calm = frame();
  happen(BurstKind::package, kOpenSea, 6, true);
  const core::Image rings = frame();
  int below = 0, above = 0;
  for (std::size_t i = 0; i < rings.rgba.size(); i += 4) {
    const bool isChanged = rings.rgba[i] != calm.rgba[i] || rings.rgba[i + 2] != calm.rgba[i + 2];
    (i / 4 / kSize.width < kSize.height / 4 ? above : below) += isChanged;
  }
  EXPECT_GT(below, 200);
  EXPECT_EQ(above, 0);
}

TEST_F(DustAndSprayGLTest, U04_aBurstFarOutIsThatOfTheOrigin) {
  // Dust and drops before the sky change the picture's light 1e9 m out as they do near the origin: within 1
  // %.
  begin();
  const auto before = [&](const glm::dvec3& at) {
    snapshot_.bursts.clear();
    happen(BurstKind::crash, at, 1.2, false);
    sceneRenderer_->camera().setPose(at - glm::dvec3(15, 3, 0), 0, 25 * kDegree, 0);
    return change();
  };
  const double here = before({0, 3000, 0});
  EXPECT_GT(here, 0);
  EXPECT_TRUE(
      test::holds("U04", std::abs(before({1e9, 3000, -1e9}) / here - 1), test::below(0.01), "of the light"));
}

TEST_F(DustAndSprayGLTest, U05_lightStaysWithinHalfFloats) {
  // An eye in the middle of each kind, at ages from none to the end, with a low sun behind: finite, none
  // below 0, none above what is kept.
  begin({"render.sun.elevationDegrees=3", "render.sun.azimuthDegrees=90", "dustAndSpray.amount=3"});
  test::noFaults("U05", "lights");
  float brightest = 0;
  for (const BurstKind kind : {BurstKind::package, BurstKind::crash, BurstKind::ditching}) {
    for (const bool onWater : {true, false}) {
      for (const double age : {0.0, 1e-4, 0.4, 2.0, game::kBurstSeconds}) {
        snapshot_.bursts.clear();
        happen(kind, kOpenSea, age, onWater);
        sceneRenderer_->camera().setPose(kOpenSea + glm::dvec3(0, 0.8, 0), 0, 3 * kDegree, 0);
        for (const float value : light()) {
          ASSERT_TRUE(value >= 0) << age;
          brightest = std::max(brightest, value);
        }
      }
    }
  }
  EXPECT_LT(brightest, 65504) << "where drivers cut what a half float does not keep";
}

TEST_F(DustAndSprayGLTest, U06_manyBurstsAreBounded) {
  // As many crashes in view as are kept have no more particles than 24 full bursts; the newest is drawn.
  test::noFaults("U06", "numbers of particles");
  begin({"dustAndSpray.particles=64"});
  for (std::uint32_t i = 0; i < game::kMostBursts; ++i)
    happen(BurstKind::crash, kOpenSea + glm::dvec3(0, 0, 4.0 * (i % 10)), 1, i % 2 == 0, i + 1);
  look(kOpenSea, 25, 5);
  frame();
  const double most = render::SprayPass::kMostFull * 64.0;
  EXPECT_GT(particles(), most / 2);
  EXPECT_LE(static_cast<double>(particles()), most);
}

TEST_F(DustAndSprayGLTest, everyTenthOfEveryRowMakesADifference) {
  begin();
  for (const double away : {20.0, 150.0, 400.0, 700.0, 900.0, 1150.0, 1400.0, 1650.0, 1900.0, 2100.0, 2300.0})
    happen(BurstKind::crash, kOpenSea + glm::dvec3(away, 0, 0.15 * away), 1.2, false);
  happen(BurstKind::rolling, kOpenSea + glm::dvec3(60, 0, -4), 0.6, false);  // never opaque
  sceneRenderer_->camera().setPose(kOpenSea + glm::dvec3(0, 12, 0), 0, -2 * kDegree, 0);
  const int rows = test::expectNoIdleSteps(run_->table, {"dustAndSpray."}, [&] {
    sceneRenderer_->apply(SettingsChange::ofAll(run_->table));
    core::StateHasher h;
    for (const auto byte : frame().rgba) h.add(std::uint64_t{byte});
    h.add(std::uint64_t{particles()});
    return h.value();
  });
  EXPECT_EQ(rows, 3);
}

}  // namespace
}  // namespace skydrop::app
