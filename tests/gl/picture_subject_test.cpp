#include "app/studies/picture_subject.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "app/measure/stopwatch.h"
#include "skydrop/core/error.h"
#include "skydrop/render/frame/pass.h"
#include "support/gl_test.h"
#include "support/shared_noise.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

constexpr Size kSize{64, 36};

class PictureSubjectGLTest : public test::GLTest {
 protected:
  void SetUp() override {
    setenv("XDG_CACHE_HOME", test::sharedCacheHome().c_str(), 1);
    test::GLTest::SetUp();
  }
  accuracy::Experiment experiment(accuracy::Assignments set, const std::string& timed = "frame") const {
    return {.where = {.name = "a",
                      .scene = scene_,
                      .pose = {{0, 400, 0, 20, 0, 0}},
                      .flight = {},
                      .seconds = 0,
                      .set = {}},
            .set = std::move(set),
            .timed = timed};
  }

  test::TemporaryFolder folder_;
  std::string scene_ = folder_.write("small.json", R"({"schema": 1, "effects": ["sky", "haze", "terrain"]})");
};

TEST_F(PictureSubjectGLTest, aPictureIsTheSameBitsWhateverWasDrawnBefore) {
  // Settings that change while flying and those that make another scene, back and forth.
  PictureSubject subject(kSize);
  const auto coarse = experiment({"streaming.pixelError=16", "streaming.cellPixels=200"});
  const auto fine = experiment({"streaming.pixelError=0.5"});
  const auto otherLand = experiment({"terrain.mountainHeight=200"});
  const accuracy::Observation first = subject.observe(coarse);
  ASSERT_EQ(first.values.size(), 3u * 64 * 36);
  EXPECT_EQ(first.seen.size(), first.values.size());
  const accuracy::Observation second = subject.observe(fine);
  EXPECT_NE(second.values, first.values);
  EXPECT_NE(subject.observe(otherLand).values, second.values);
  EXPECT_EQ(subject.observe(coarse).values, first.values);
  EXPECT_EQ(PictureSubject(kSize).observe(fine).values, second.values);
  context().makeCurrent();
}

TEST_F(PictureSubjectGLTest, aFlightIsJudgedByItsLastFrame) {
  // Without history that is the frame at its last place alone; with history it holds what frames before it
  // left, and is the same bits again.
  scene_ = "fair";
  test::sharedNoise();
  PictureSubject subject(kSize);
  const auto flown = [&](const std::string& history) {
    accuracy::Experiment e = experiment({"clouds.tier=medium", "clouds.march.history=" + history});
    e.where.pose = {{0, 600, 0, 40, 12, 0}};
    e.where.flight = accuracy::StudyFlight{.speedMps = 120, .bankDegrees = 0, .frames = 12};
    return e;
  };
  accuracy::Experiment last = flown("off");
  last.where.pose = accuracy::flownPose(*last.where.pose, *last.where.flight, 12);
  last.where.flight = {};
  const accuracy::Observation off = subject.observe(flown("off"));
  const accuracy::Observation quarter = subject.observe(flown("quarter"));
  EXPECT_NE(off.values, quarter.values);
  EXPECT_EQ(subject.observe(flown("off")).values, off.values);
  EXPECT_EQ(subject.observe(flown("quarter")).values, quarter.values);
  // The clock of the sky and the wind went on for 12 frames: a fifth of a second moves clouds by metres.
  const accuracy::Observation there = subject.observe(last);
  double difference = 0, mean = 0;
  for (std::size_t i = 0; i < there.values.size(); ++i) {
    difference += std::abs(there.values[i] - off.values[i]);
    mean += std::abs(there.values[i]);
  }
  EXPECT_LT(difference / mean, 0.02);
  context().makeCurrent();
}

TEST_F(PictureSubjectGLTest, whatIsMadeAnewForAPointIsInItsPicture) {
  // Textures of the planes are made on another thread: the picture waits for them, whatever was drawn before.
  scene_ = "plane3";
  PictureSubject subject(kSize);
  const auto sided = [&](const char* side) {
    return experiment({std::string("cloudPlanes.layers.0.textureSide=") + side});
  };
  const accuracy::Observation coarse = subject.observe(sided("64")), fine = subject.observe(sided("512"));
  EXPECT_NE(coarse.values, fine.values);
  EXPECT_EQ(PictureSubject(kSize).observe(sided("512")).values, fine.values);
  context().makeCurrent();
}

TEST_F(PictureSubjectGLTest, whatIsSeenRoundsToWhatIsDrawn) {
  // The tone-mapped light of the frame is its 8-bit picture before rounding and dither, to two steps.
  PictureSubject subject(kSize);
  const accuracy::Observation o = subject.observe(experiment({}));
  double worst = 0;
  for (std::size_t i = 0; i < o.seen.size(); ++i)
    worst = std::max(worst, std::abs(o.seen[i] * 255 - o.display.rgba[i / 3 * 4 + i % 3]));
  EXPECT_LT(worst, 2);
  context().makeCurrent();
}

TEST_F(PictureSubjectGLTest, severalSamplesAPixelConverge) {
  // 64 and 32 samples agree better than either does with one, and the picture of one sample is as before.
  PictureSubject subject(kSize);
  const auto sampled = [&](const char* samples) {
    return subject.observe(
        experiment({std::string("samples=") + samples, "render.picture.smoothEdges=false"}));
  };
  const accuracy::Observation one = subject.observe(experiment({"render.picture.smoothEdges=false"}));
  const accuracy::Observation many = sampled("64"), half = sampled("32");
  const auto apart = [](const accuracy::Observation& a, const accuracy::Observation& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.seen.size(); ++i) sum += (a.seen[i] - b.seen[i]) * (a.seen[i] - b.seen[i]);
    return std::sqrt(sum / static_cast<double>(a.seen.size()));
  };
  EXPECT_LT(apart(many, half), 0.25 * apart(many, one));
  EXPECT_GT(apart(many, one), 0.003);
  EXPECT_EQ(sampled("1").values, one.values);
  EXPECT_EQ(sampled("64").values, many.values);
  EXPECT_THROW((void)subject.checked(experiment({"samples=0"})), core::RangeError);
  EXPECT_THROW((void)subject.checked(experiment({"samples=x"})), core::RangeError);
  context().makeCurrent();
}

class SlowPass final : public render::Pass {
 public:
  static constexpr int kMs = 60;
  std::string_view name() const override { return "slow"; }
  render::RenderStage stage() const override { return render::RenderStage::sky; }
  // The card has come to the query that begins before the wait does.
  void draw(render::FrameContext& frame) override {
    frame.gl.api().Finish();
    std::this_thread::sleep_for(std::chrono::milliseconds(kMs));
  }
};

TEST_F(PictureSubjectGLTest, aSlowPassShowsUpWhereItIsWithinAFifthOfTheWallClock) {
  // A pass that waits for 60 ms takes those in its own time and in that of the frame, and in no other pass.
  std::vector<EffectDescriptor> table = effectTable();
  for (EffectDescriptor& row : table) {
    if (row.effect == scene::Effect::haze)
      row.addPasses = [](SceneRenderer& renderer) { renderer.renderer().add(std::make_unique<SlowPass>()); };
  }
  PictureSubject subject(kSize, table);
  subject.timeOnce(experiment({}));
  const Stopwatch watch;
  std::this_thread::sleep_for(std::chrono::milliseconds(SlowPass::kMs));
  const double wall = watch.ms();
  EXPECT_NEAR(subject.timeOnce(experiment({}, "pass slow")), wall, 0.2 * wall);
  EXPECT_EQ(subject.clock(experiment({}, "pass slow")),
            context().isSoftware() ? "wall clock between glFinish calls" : "timer query");
  EXPECT_GE(subject.timeOnce(experiment({})), SlowPass::kMs);
  EXPECT_LT(subject.timeOnce(experiment({}, "pass sky")), 0.8 * wall);
  EXPECT_EQ(subject.timeOnce(experiment({}, "pass clouds")), 0) << "there is none";
  EXPECT_NEAR(subject.timeOnce(experiment({}, "pass sky+slow+clouds")), wall, 0.2 * wall) << "together";
  context().makeCurrent();
}

TEST_F(PictureSubjectGLTest, judgesPathsValuesAndScenesWithoutDrawing) {
  const PictureSubject subject(kSize);
  EXPECT_EQ(subject.checked(experiment({"streaming.pixelError=4.0"})),
            accuracy::Assignments{"streaming.pixelError=4"});
  EXPECT_THROW(subject.checked(experiment({"streaming.pixelErrors=4"})), core::UsageError);
  EXPECT_THROW(subject.checked(experiment({"streaming.pixelError=400"})), core::UsageError);
  EXPECT_THROW(subject.checked(experiment({}, "cpu")), core::RangeError);
}

}  // namespace
}  // namespace skydrop::app
