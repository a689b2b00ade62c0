#include "app/session/split_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/session/observed_picture.h"
#include "app/session/run_config.h"
#include "support/gl_test.h"
#include "support/shared_noise.h"

namespace skydrop::app {
namespace {

constexpr Size kSize{100, 60};

class SplitViewGLTest : public test::GLTest {
 protected:
  void start(const char* scene, std::vector<std::string> set) {
    CommandLine line;
    line.verb = Verb::render;
    line.scene = scene;
    line.set = std::move(set);
    run_ = prepareRun(line);
    simulation_.emplace(run_->setup, run_->settings, run_->table);
    const scene::EffectSet& effects = simulation_->effects();
    const bool hasClouds = effects.contains(scene::Effect::clouds);
    sceneRenderer_.emplace(
        context(),
        SceneRenderer::Setup{effects, simulation_->ground(), 1, false,
                             hasClouds ? PreparedResources(test::sharedNoise()) : PreparedResources()},
        run_->settings);
    sceneRenderer_->camera().setMode(render::CameraMode::free);
    sceneRenderer_->camera().setPose({0, 600, 0}, 2.2, 0.1, 0);
  }
  void TearDown() override {
    sceneRenderer_.reset();
    simulation_.reset();
    test::GLTest::TearDown();
  }

  const game::Snapshot& now() const { return simulation_->world().now(); }
  SplitReference referenceOf(const char* words) const {
    return splitReference(run_->settings, simulation_->effects(), words);
  }
  core::Image output() { return sceneRenderer_->renderer().readBack(); }
  std::vector<float> radiance(const Settings& settings) {
    sceneRenderer_->useSettings(settings);
    sceneRenderer_->draw(now(), kSize, Streaming::settled);
    const std::vector<float> light = sceneRenderer_->renderer().readRadiance();
    sceneRenderer_->useSettings(run_->settings);
    return light;
  }

  std::unique_ptr<RunConfig> run_;
  std::optional<Simulation> simulation_;
  std::optional<SceneRenderer> sceneRenderer_;
};

// Columns from `first` to before `end` in which a and b differ by more than `steps` of 255.
int differentPixels(const core::Image& a, const core::Image& b, int first, int end, int steps = 0) {
  int count = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = first; x < end; ++x) {
      for (int k = 0; k < 3; ++k) {
        if (std::abs(a.pixel(x, y)[k] - b.pixel(x, y)[k]) <= steps) continue;
        ++count;
        break;
      }
    }
  }
  return count;
}

TEST_F(SplitViewGLTest, leftOfTheDividerIsThePresentPictureAndRightOfItTheReference) {
  // Bit for bit those that are drawn by themselves; the divider where the settings say.
  start("fair", {"quality=low", "view.split.divider=0.25"});
  const SplitReference reference = referenceOf("clouds=high");
  const core::Image present = seenPicture(radiance(run_->settings), kSize.width, kSize.height),
                    right = seenPicture(radiance(reference.settings), kSize.width, kSize.height);
  ASSERT_GT(differentPixels(present, right, 0, kSize.width), 500);
  SplitView split(*sceneRenderer_, run_->settings, reference);
  split.makeWhole(now(), kSize);
  split.draw(now(), kSize, 0);
  const core::Image shown = output();
  EXPECT_EQ(differentPixels(shown, present, 0, 23), 0);
  EXPECT_EQ(differentPixels(shown, right, 27, kSize.width), 0);
  EXPECT_EQ(shown.pixel(25, 30)[0], 255);  // the line
  EXPECT_EQ(shown.pixel(26, 30)[0], 0);    // its rim
  split.setDivider(0.75);
  split.draw(now(), kSize, 0);
  EXPECT_EQ(differentPixels(output(), present, 0, 73), 0);
}

TEST_F(SplitViewGLTest, theHeatMapTakesThePlaceOfTheReferenceAndTheErrorIsThatOfTheTwoPictures) {
  start("fair", {"quality=low", "view.split.heat=true"});
  const SplitReference reference = referenceOf("clouds=high");
  const std::vector<float> a = radiance(run_->settings), r = radiance(reference.settings);
  SplitView split(*sceneRenderer_, run_->settings, reference);
  split.makeWhole(now(), kSize);
  split.draw(now(), kSize, 0);
  double squares = 0, mean = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    squares += std::pow(double(a[i]) - double(r[i]), 2), mean += std::abs(double(r[i]));
  const double rmse = std::sqrt(squares / static_cast<double>(a.size()));
  ASSERT_TRUE(split.error() && split.error()->isComplete());
  EXPECT_NEAR(split.error()->rmse, rmse, 1e-9 * rmse);
  EXPECT_NEAR(split.error()->relativeRmse, rmse * static_cast<double>(a.size()) / mean, 1e-9);
  EXPECT_GT(*split.error()->flip, 0.001);
  const core::Image right = seenPicture(r, kSize.width, kSize.height), heat = output();
  EXPECT_GT(differentPixels(heat, right, 53, kSize.width), 2000);
  split.setHeat(false);
  split.draw(now(), kSize, 0);
  EXPECT_EQ(differentPixels(output(), right, 53, kSize.width), 0);
}

TEST_F(SplitViewGLTest, inPartsTheReferenceIsRefinedUntilItIsTheWholePicture) {
  // One part a frame, of a tier with a ray for each pixel, as the reference has. Rays of parts are those of
  // the whole but for rounding, which the noise's edges can turn into a step of colour at single pixels: at
  // most one in a hundred differs by more than two of 255.
  start("fair", {"quality=low"});
  const SplitReference reference = referenceOf("clouds=ultra");
  const core::Image right = seenPicture(radiance(reference.settings), kSize.width, kSize.height);
  SplitView split(*sceneRenderer_, run_->settings, reference);
  double share = 0;
  int frames = 0, partial = 0;
  while (!split.error() || !split.error()->isComplete()) {
    split.draw(now(), kSize, 0);
    EXPECT_GE(split.share(), share);
    share = split.share();
    partial += split.error() && !split.error()->isComplete();
    ASSERT_LT(++frames, 100000);
  }
  EXPECT_EQ(share, 1);
  EXPECT_GT(frames, 20);
  EXPECT_GT(partial, 0) << "no error was given before all was drawn";
  EXPECT_LE(differentPixels(output(), right, 53, kSize.width, 2), 47 * 60 / 100);
}

TEST_F(SplitViewGLTest, anotherViewBeginsAgainWithThePresentSettings) {
  start("terrain", {"quality=low"});
  SplitView split(*sceneRenderer_, run_->settings, referenceOf("land=reference"));
  while (!split.error() || !split.error()->isComplete()) split.draw(now(), kSize, 1e3);
  sceneRenderer_->camera().setPose({0, 700, 0}, 2.2, -0.1, 0);
  split.draw(now(), kSize, 1e3);
  EXPECT_EQ(split.share(), 0);
  EXPECT_FALSE(split.error());
  EXPECT_EQ(&sceneRenderer_->settings(), &run_->settings);
}

TEST_F(SplitViewGLTest, whatItNeedsIsMadeWhenItBeginsAndGoneWhenItEnds) {
  // The ledger of objects and bytes, programs included, is what it was in a frame like the one before; the
  // renderer draws by the present settings again, and the picture is the same bits.
  for (const auto& [scene, words] :
       {std::pair("fair", "clouds=high"), std::pair("terrain", "land=reference")}) {
    start(scene, {"quality=low"});
    const auto frame = [&] {
      sceneRenderer_->draw(now(), kSize, Streaming::settled);
      return output();
    };
    const core::Image before = frame();
    const render::gl::GpuResourceTracker& ledger = context().resources();
    // Without the timer's queries, whose number is that of passes under way (none on a software renderer).
    const auto objectsOf = [&] { return ledger.liveObjects() - ledger.live(render::gl::ObjectKind::query); };
    const std::int64_t objects = objectsOf();
    const std::uint64_t bytes = ledger.bytes();
    {
      SplitView split(*sceneRenderer_, run_->settings, referenceOf(words));
      while (!split.error() || !split.error()->isComplete()) split.draw(now(), kSize, 1e3);
      EXPECT_GT(objectsOf(), objects);  // in bytes it may be less: clouds are drawn in parts
      EXPECT_NE(&sceneRenderer_->settings(), &run_->settings);
    }
    EXPECT_EQ(&sceneRenderer_->settings(), &run_->settings);
    EXPECT_EQ(differentPixels(frame(), before, 0, kSize.width), 0) << scene;
    EXPECT_EQ(objectsOf(), objects) << scene;
    EXPECT_EQ(ledger.bytes(), bytes) << scene;
    sceneRenderer_.reset();
    simulation_.reset();
  }
}

}  // namespace
}  // namespace skydrop::app
