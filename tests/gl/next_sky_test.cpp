// Frames that follow each other while the tables of another sky are being made.
#include "skydrop/render/frame/next_sky.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "skydrop/render/sky/sky_pass.h"
#include "skydrop/sky/instant.h"
#include "support/frame_test.h"

namespace skydrop::render {
namespace {

class NextSkyGLTest : public test::FrameTest {
 protected:
  void SetUp() override {
    FrameTest::SetUp();
    if (IsSkipped()) return;
    renderer().add(std::make_unique<SkyPass>(context()));
    settings_.sun = {17.3, 90};
    settings_.atmosphere.visibilityM = 71'300;  // an air of which nobody has made corners
  }
  FrameInput input(bool follows) const {
    FrameInput input = gameFrame(snapshot_, pose({0, heightM_, 0}, 60, 10, 0, 64, 36), features_);
    input.followsLast = follows;
    return input;
  }
  // Linear light of a frame.
  std::vector<float> frame(bool follows) {
    draw(input(follows));
    return renderer().readRadiance();
  }
  // Rows of tables that a frame that waits for its own would make.
  int missing() const {
    const SkyPlaces places = skyPlaces(settings_, heightM_, 0);
    const auto views = sky::SkyViews::of(atmosphereOf(settings_.atmosphere));
    return views->missingRows(places.sun) + (places.moon ? views->missingRows(*places.moon) : 0);
  }
  // Follows until all is there; returns after how many frames. No frame makes more than a slice; what has
  // been begun for another sun is finished first.
  int framesUntilThere() {
    int frames = 0;
    for (int before = missing(); before > 0 && frames < 100; ++frames) {
      frame(true);
      const int now = missing();
      EXPECT_LE(before - now, NextSky::kRowsAFrame);
      EXPECT_LE(now, before);
      before = now;
    }
    return frames;
  }

  double heightM_ = 500;
};

TEST_F(NextSkyGLTest, aSunThatJumpsIsFollowedInSlices) {
  // Four corners of 80 rows are missing; no frame makes more than kRowsAFrame of them, and then the frame is
  // the one that waits for all at once, bit for bit.
  frame(false);
  for (const double elevation : {44.2, 3.1, -8.4}) {
    settings_.sun.elevationDegrees = elevation;
    EXPECT_EQ(missing(), 320) << elevation;
    EXPECT_EQ(framesUntilThere(), 320 / NextSky::kRowsAFrame);
    const auto now = frame(true);
    EXPECT_EQ(frame(false), now);
  }
}

TEST_F(NextSkyGLTest, aMoonIsFollowedInSlicesTooAndACutIsNot) {
  settings_.sun.source = SunSource::clock;
  settings_.sun.utcMs = sky::parseInstant("2026-09-26T12:00:00Z").utcMs;
  frame(false);
  settings_.sun.shiftHours = 8.7;  // a full moon
  EXPECT_EQ(missing(), 640);
  EXPECT_EQ(framesUntilThere(), 640 / NextSky::kRowsAFrame);
  auto now = frame(true);
  EXPECT_EQ(frame(false), now);
  heightM_ = 7300;
  EXPECT_EQ(missing(), 640);
  now = frame(true);  // bit for bit what a first frame shows from there
  EXPECT_EQ(frame(false), now);
}

TEST_F(NextSkyGLTest, aSunThatRunsIsFollowed) {
  // 0.31 degrees a frame, more than a cell of the tables: no frame makes more than a slice beside the rows
  // that are made ahead, and the sky still changes at least every eighth frame.
  frame(false);
  std::vector<float> shown = frame(true);
  int unchanged = 0, most = 0;
  for (int i = 0; i < 40; ++i) {
    settings_.sun.elevationDegrees -= 0.31;
    const auto now = frame(true);
    unchanged = now == shown ? unchanged + 1 : 0;
    most = std::max(most, unchanged);
    shown = now;
  }
  EXPECT_LT(most, 8);
  EXPECT_LE(framesUntilThere(), 2 * 320 / NextSky::kRowsAFrame);
  const auto now = frame(true);
  EXPECT_EQ(frame(false), now);
}

TEST_F(NextSkyGLTest, aSettledFrameHasItsOwnSky) {
  frame(false);
  settings_.sun.elevationDegrees = 61;
  const auto late = frame(true);
  renderer().settle(input(true));
  const auto settled = frame(true);
  EXPECT_NE(settled, late);
  EXPECT_EQ(frame(false), settled);
}

}  // namespace
}  // namespace skydrop::render
