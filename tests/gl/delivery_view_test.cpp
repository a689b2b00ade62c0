// The small picture of a package: a second view of the scene over the frame's output.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <vector>

#include "app/session/package_camera.h"
#include "app/session/run_config.h"
#include "app/session/scene_renderer.h"
#include "support/gl_test.h"

namespace skydrop::app {
namespace {

class DeliveryViewGLTest : public test::GLTest {
 protected:
  void SetUp() override {
    test::GLTest::SetUp();
    if (IsSkipped()) return;
    CommandLine line;
    line.verb = Verb::render;
    line.scene = "terrain";
    line.set = {"quality=low"};
    run_ = prepareRun(line);
    simulation_ = std::make_unique<Simulation>(run_->setup, run_->settings, run_->table);
    simulation_->step({.drop = true});
    for (int i = 0; i < 360; ++i) simulation_->step({});
    renderer_ = std::make_unique<SceneRenderer>(
        context(), SceneRenderer::Setup{simulation_->effects(), simulation_->ground(), 1}, run_->settings);
  }
  const game::Snapshot& now() const { return simulation_->world().now(); }

  std::unique_ptr<RunConfig> run_;
  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<SceneRenderer> renderer_;
  PackageCamera camera_;
};

TEST_F(DeliveryViewGLTest, theSmallPictureLiesInItsPlaceAndChangesNothingElse) {
  // The frame beside it is bit for bit that of a renderer without; in its place lies what the camera of the
  // package sees: the frame that is drawn from there.
  constexpr Size kFrame{320, 180}, kInset{96, 54};
  renderer_->draw(now(), kFrame, Streaming::settled);
  const core::Image plain = renderer_->renderer().readBack();
  ASSERT_TRUE(camera_.begin(now()));
  const auto view = camera_.view(now(), run_->settings.render.camera, kInset, simulation_->ground().get());
  ASSERT_TRUE(view);
  bool drawn = false;
  for (int i = 0; i < 40 && !drawn; ++i)
    drawn = renderer_->drawInset(now(), *view);  // compiles one at a time
  ASSERT_TRUE(drawn);
  renderer_->draw(now(), kFrame, Streaming::settled);
  renderer_->showInset(200, 100);  // from the lower left corner
  const core::Image both = renderer_->renderer().readBack();
  int outside = 0, inside = 0;
  for (int y = 0; y < kFrame.height; ++y) {
    for (int x = 0; x < kFrame.width; ++x) {
      const bool isInset = x >= 200 && x < 296 && y >= 180 - 100 - 54 && y < 180 - 100;
      bool differs = false;
      for (int c = 0; c < 3; ++c) differs = differs || plain.pixel(x, y)[c] != both.pixel(x, y)[c];
      (isInset ? inside : outside) += differs ? 1 : 0;
    }
  }
  EXPECT_EQ(outside, 0);
  EXPECT_GT(inside, 96 * 54 / 2);
  // Beyond the edges it is cut, and nothing is written elsewhere.
  renderer_->showInset(300, 170);
  renderer_->showInset(-5, 10);
  renderer_->endInset();
  renderer_->showInset(0, 0);
}

TEST_F(DeliveryViewGLTest, whatItNeedsGoesWithIt) {
  // Shown and ended again and again the GPU holds as much as after the first time, and less than while it is
  // shown.
  const auto live = [&] { return context().resources().live(render::gl::ObjectKind::frameBuffer); };
  ASSERT_TRUE(camera_.begin(now()));
  const auto view = camera_.view(now(), run_->settings.render.camera, {64, 36}, nullptr);
  std::int64_t first = 0;
  for (int round = 0; round < 3; ++round) {
    for (int i = 0; i < 40 && !renderer_->drawInset(now(), *view); ++i) {
    }
    renderer_->draw(now(), {160, 90}, Streaming::settled);
    const std::int64_t shown = live();
    renderer_->endInset();
    renderer_->draw(now(), {160, 90}, Streaming::settled);
    EXPECT_LT(live(), shown);
    if (round == 0) first = live();
    EXPECT_EQ(live(), first);
  }
}

TEST_F(DeliveryViewGLTest, theSmallPictureCostsLessThanAFrame) {
  // At 640 x 360, frames with and without it in turn: the least of either, by processor time of all threads,
  // which other programs disturb less. It is a fourteenth of the pixels; the land's triangles are drawn
  // twice.
  constexpr Size kFrame{640, 360}, kInset{166, 93};
  ASSERT_TRUE(camera_.begin(now()));
  const auto view = camera_.view(now(), run_->settings.render.camera, kInset, simulation_->ground().get());
  renderer_->draw(now(), kFrame, Streaming::settled);
  for (int i = 0; i < 40 && !renderer_->drawInset(now(), *view); ++i) {
  }
  std::vector<double> plain, both;
  for (int i = 0; i < 14; ++i) {
    renderer_->renderer().finish();
    const std::clock_t begin = std::clock();
    if (i % 2 == 1) renderer_->drawInset(now(), *view);
    renderer_->draw(now(), kFrame, Streaming::asItComes);
    if (i % 2 == 1) renderer_->showInset(400, 200);
    renderer_->renderer().finish();
    (i % 2 == 1 ? both : plain).push_back(1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  std::ranges::sort(plain), std::ranges::sort(both);
  const double ratio = both[0] / plain[0];
  std::printf("frame %.1f ms, with the small picture %.1f ms: %.2f times\n", plain[0], both[0], ratio);
  EXPECT_LT(ratio, 1.8);
}

TEST_F(DeliveryViewGLTest, theCameraLooksAtThePackageAndStaysAboveTheLand) {
  ASSERT_TRUE(camera_.begin(now()));
  game::Snapshot low = now();
  low.packages[0].position.y =
      simulation_->ground()->height({low.packages[0].position.x, low.packages[0].position.z});
  for (const game::Snapshot& snapshot : {now(), low}) {
    const auto view =
        camera_.view(snapshot, run_->settings.render.camera, {64, 36}, simulation_->ground().get());
    ASSERT_TRUE(view);
    const glm::dvec3 way = snapshot.packages[0].position - view->position;
    EXPECT_GT(glm::dot(glm::normalize(way), view->forward()), 0.95);
    EXPECT_GT(view->position.y, simulation_->ground()->height({view->position.x, view->position.z}) + 2);
  }
  low.packages.clear();
  EXPECT_FALSE(camera_.follow(low));
  EXPECT_FALSE(camera_.begin(low));
}

}  // namespace
}  // namespace skydrop::app
