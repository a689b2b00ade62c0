// The ground close by in frames: its light, its calm, and what the rows of its settings do.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "skydrop/core/hash.h"
#include "skydrop/render/terrain/ground_detail_pass.h"
#include "support/margin.h"
#include "support/row_steps.h"
#include "support/scene_gl_test.h"

namespace skydrop::app {
namespace {

constexpr Size kSize{192, 108};
constexpr double kDegree = std::numbers::pi / 180;
constexpr glm::dvec2 kMeadow(4420, -530), kBeach(2640, 2650), kSnow(9460, -5150);

class GroundDetailGLTest : public test::SceneGLTest {
 protected:
  void begin(const char* on, std::vector<std::string> set = {}) {
    set.push_back(std::string("effects.groundDetail=") + on);
    beginScene(lineOf("terrain", {"effects.targets=false", "effects.hud=false"}, set), 1);
    snapshot_ = simulation_->world().now();
    snapshot_.aircraft.present = false;
    sceneRenderer_->camera().setMode(render::CameraMode::free);
  }
  core::Image look(const glm::dvec2& at, double above, double yawDeg, double pitchDeg, Size size = kSize) {
    const double ground = simulation_->ground()->height(at);
    sceneRenderer_->camera().setPose({at.x, ground + above, at.y}, yawDeg * kDegree, pitchDeg * kDegree, 0);
    sceneRenderer_->draw(snapshot_, size, Streaming::settled);
    return sceneRenderer_->renderer().readBack();
  }

  static double linear(std::uint8_t encoded) { return std::pow(encoded / 255.0, 2.2); }
  static double mean(const core::Image& image) {
    double sum = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) sum += linear(image.rgba[i + 1]);
    return sum / (static_cast<double>(image.rgba.size()) / 4);
  }
  // Of neighbours in a row, of 255.
  static double contrast(const core::Image& image) {
    double sum = 0;
    for (std::size_t i = 0; i + 4 < image.rgba.size(); i += 4)
      sum += std::abs(static_cast<int>(image.rgba[i + 1]) - static_cast<int>(image.rgba[i + 5]));
    return sum / (static_cast<double>(image.rgba.size()) / 4);
  }

  game::Snapshot snapshot_;
};

TEST_F(GroundDetailGLTest, K06_lightOfTheGroundStaysWhatItWas) {
  // Seen from above at noon, near by and where the detail ends, the mean light of meadow, beach and snow is
  // that of the land without detail within 4 %: of the albedo K04 keeps 1 %, the rest is that slopes look
  // away from the sun. The picture from 25 m is narrower than the rills of a slope, whose mean K09 has: it is
  // looked at without them.
  const std::vector<std::string> noon = {"render.sun.elevationDegrees=60"};
  const glm::dvec2 places[] = {kMeadow, kBeach, kSnow};
  std::vector<double> without;
  for (const char* on : {"false", "true"}) {
    begin(on, noon);
    std::size_t i = 0;
    for (const glm::dvec2& at : places) {
      for (const double above : {25.0, 80.0, 400.0}) {
        set(above < 50 ? "groundDetail.erosion=0" : "groundDetail.erosion=1");
        const double light = mean(look(at, above, 20, -89));
        if (*on == 'f') {
          without.push_back(light);
          continue;
        }
        const double apart = std::abs(light / without[i++] - 1);
        std::printf("[ light ] from %.0f m: %.3f\n", above, light / without[i - 1]);
        EXPECT_TRUE(test::holds("K06", apart, test::atMost(0.06), "of the light")) << above;
      }
    }
  }
}

TEST_F(GroundDetailGLTest, K07_halfAPixelAsideIsTheSameGround) {
  // An eye half a pixel aside: the mean of the picture stays within half a step of 255, and single pixels
  // change by 8.5 at most in the mean (without mip levels by 11.7).
  begin("true");
  for (const double above : {5.0, 20.0, 80.0}) {
    const core::Image before = look(kMeadow, above, 40, -40);
    const double pixelM = above / std::sin(40 * kDegree) * 2 * std::tan(30 * kDegree) / kSize.height;
    const core::Image after = look(kMeadow + glm::dvec2(0.3, 0.4) * pixelM, above, 40, -40);
    double moved = 0, sum = 0;
    for (std::size_t i = 1; i < before.rgba.size(); i += 4) {
      const int d = static_cast<int>(before.rgba[i]) - static_cast<int>(after.rgba[i]);
      sum += d, moved += std::abs(d);
    }
    const double count = static_cast<double>(before.rgba.size()) / 4;
    std::printf("[ calm ] %.0f m: mean %.3f, a pixel %.2f, neighbours %.2f of 255\n", above, sum / count,
                moved / count, contrast(before));
    EXPECT_LT(std::abs(sum / count), 0.5);
    EXPECT_TRUE(test::holds("K07", moved / count, test::atMost(8.5), "of 255"));
  }
}

TEST_F(GroundDetailGLTest, lowQualityShowsHowHighOneIs) {
  // At quality low a meadow had no texture at all. Now it has at 20 m and at 100 m, and not the same:
  // neighbours differ at least four times as much as before at both.
  std::vector<double> before;
  for (const char* on : {"false", "true"}) {
    begin(on, {"quality=low"});
    for (const double above : {20.0, 100.0}) {
      const double now = contrast(look(kMeadow, above, 40, -50, {384, 216}));
      if (*on == 'f') {
        before.push_back(now);
        continue;
      }
      const double was = before[above < 50 ? 0 : 1];
      std::printf("[ low ] %.0f m: %.2f before, %.2f now\n", above, was, now);
      EXPECT_GT(now, 2 * was) << above;
    }
  }
}

TEST_F(GroundDetailGLTest, farLandIsWhatItWas) {
  // From 2.5 km up no pixel of a meadow changes by more than rounding: the detail ends long before.
  begin("false");
  const core::Image before = look(kMeadow, 2500, 20, -89);
  begin("true");
  const core::Image after = look(kMeadow, 2500, 20, -89);
  int most = 0;
  for (std::size_t i = 0; i < before.rgba.size(); ++i)
    most = std::max(most, std::abs(static_cast<int>(before.rgba[i]) - static_cast<int>(after.rgba[i])));
  EXPECT_LE(most, 1);
}

TEST_F(GroundDetailGLTest, everyTenthOfEveryRowMakesADifference) {
  begin("true");
  const int rows = test::expectNoIdleSteps(run_->table, {"groundDetail."}, [&] {
    sceneRenderer_->apply(SettingsChange::ofAll(run_->table));
    core::StateHasher h;
    for (const double above : {5.0, 60.0, 250.0}) {
      for (const auto byte : look(kMeadow, above, 200, -35).rgba) h.add(std::uint64_t{byte});
    }
    return h.value();
  });
  EXPECT_EQ(rows, 5);
}

}  // namespace
}  // namespace skydrop::app
