// Frames that follow each other while the tables of another air are being made.
#include "skydrop/render/frame/next_air.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>
#include <vector>

#include "skydrop/core/cpu_clock.h"
#include "skydrop/render/sky/sky_pass.h"
#include "skydrop/sky/atmosphere.h"
#include "support/frame_test.h"

namespace skydrop::render {
namespace {

class NextAirGLTest : public test::FrameTest {
 protected:
  void SetUp() override {
    FrameTest::SetUp();
    if (IsSkipped()) return;
    renderer().add(std::make_unique<SkyPass>(context()));
    settings_.sun = {12, 90};
    settings_.atmosphere.visibilityM = 77'000;
  }
  // Linear light of a frame.
  std::vector<float> frame(bool follows) {
    FrameInput input = gameFrame(snapshot_, pose({0, 500, 0}, 60, 10, 0, 64, 36), features_);
    input.followsLast = follows;
    draw(input);
    return renderer().readRadiance();
  }
  // Follows until the picture changes.
  std::vector<float> changed(const std::vector<float>& from) {
    for (int i = 0; i < 2000; ++i) {
      const auto picture = frame(true);
      if (picture != from) return picture;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    ADD_FAILURE() << "the air never comes";
    return from;
  }
};

TEST_F(NextAirGLTest, framesGoOnInTheOldAirUntilTheNewOneIsThere) {
  // The frame after the change is that of before bit for bit, and does less work on its thread than a third
  // of what the tables take; then comes the frame that one without a window has at once.
  const auto old = frame(false);
  EXPECT_EQ(frame(true), old);
  core::CpuClock tablesClock;
  sky::SkyViews::of(sky::makeAtmosphere(3'333, 700, 0.3))->view(500, 0.2);
  const double tablesMs = tablesClock.ms();
  settings_.atmosphere.visibilityM = 9'100;
  const core::CpuClock clock;
  EXPECT_EQ(frame(true), old);
  EXPECT_LT(clock.ms(), tablesMs / 3);
  const auto now = changed(old);
  EXPECT_EQ(frame(false), now);
  settings_.atmosphere.visibilityM = 9'200;
  EXPECT_NE(frame(false), now) << "a frame that follows none waits";
}

TEST_F(NextAirGLTest, whatIsNotWantedAnyMoreIsNeverShown) {
  // Changed and changed back, and changed in a frame that follows none: what was being made meanwhile is
  // left.
  const auto old = frame(false);
  settings_.atmosphere.visibilityM = 8'100;
  EXPECT_EQ(frame(true), old);
  settings_.atmosphere.visibilityM = 77'000;
  for (int i = 0; i < 60; ++i) {
    ASSERT_EQ(frame(true), old) << i;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  settings_.atmosphere.visibilityM = 8'200;
  EXPECT_EQ(frame(true), old);
  settings_.atmosphere.visibilityM = 30'000;
  const auto other = frame(false);
  EXPECT_NE(other, old);
  for (int i = 0; i < 60; ++i) {
    ASSERT_EQ(frame(true), other) << i;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

TEST_F(NextAirGLTest, aSettledFrameHasItsOwnAir) {
  const auto old = frame(false);
  settings_.atmosphere.visibilityM = 8'300;
  EXPECT_EQ(frame(true), old);
  renderer().settle(gameFrame(snapshot_, pose({0, 500, 0}, 60, 10, 0, 64, 36), features_));
  const auto settled = frame(true);
  EXPECT_EQ(frame(false), settled);
  EXPECT_NE(settled, old);
}

}  // namespace
}  // namespace skydrop::render
