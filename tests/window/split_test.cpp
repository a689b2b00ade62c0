// The split view in the real window.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>

#include "window/flown_game.h"

namespace skydrop::test {
namespace {

using nlohmann::json;

double share(const json& s) { return s.at("window").at("splitShare").get<double>(); }
bool isFrozen(const json& s) { return s.at("window").at("frozen").get<bool>(); }

TEST(SplitWindow, comesAndGoesByItsKeyAndLeavesNothing) {
  // F3 holds time and draws the reference; the error is known when all of it is there. F3 again: time goes
  // on, and objects of OpenGL are as many as before.
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown({"--set", "view.split.subject=land", "--set", "quality=low"});
  EXPECT_EQ(share(flown.statistics()), -1);
  const json before = flown.statistics().at("gl");
  flown.press("F3");
  ASSERT_TRUE(flown.waitFor([](const json& s) { return s.contains("split"); })) << flown.statistics().dump();
  const json during = flown.statistics();
  EXPECT_EQ(share(during), 1);
  EXPECT_TRUE(isFrozen(during));
  EXPECT_EQ(during.at("split").at("reference"), "land=reference");
  EXPECT_GT(during.at("split").at("rmse").get<double>(), 0);
  flown.press("F3");
  ASSERT_TRUE(flown.waitFor([](const json& s) { return share(s) == -1 && !isFrozen(s); }));
  EXPECT_FALSE(flown.statistics().contains("split"));
  const json after = flown.statistics().at("gl");
  for (const char* kind : {"programs", "framebuffers", "textures"})
    EXPECT_EQ(after.at(kind), before.at(kind)) << kind;
}

TEST(SplitWindow, withoutItsSubjectTimeGoesOn) {
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown({"--set", "quality=low"});  // the scene terrain has no clouds
  const int steps = flown.statistics().at("steps").get<int>();
  flown.press("F3");
  EXPECT_TRUE(flown.waitFor([&](const json& s) { return s.at("steps").get<int>() > steps + 240; }));
  EXPECT_EQ(share(flown.statistics()), -1);
  EXPECT_FALSE(isFrozen(flown.statistics()));
}

TEST(SplitWindow, theWindowGoesOnWhileTheReferenceIsRefined) {
  // The clouds' reference takes about a minute at this size on a processor. Frames come meanwhile: while one
  // part in twenty is drawn at least ten of them, or where a processor is so fast that this takes few seconds
  // two in each.
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown({"--scene", "fair", "--set", "quality=low"});
  flown.press("F3");
  const auto frames = [](const json& s) { return s.at("frame").at("count").get<int>(); };
  ASSERT_TRUE(flown.waitFor([](const json& s) { return share(s) > 0; })) << flown.statistics().dump();
  const json first = flown.statistics();
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_TRUE(flown.waitFor([&](const json& s) { return share(s) > share(first) + 0.05 || share(s) == 1; }));
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
  const int came = frames(flown.statistics()) - frames(first);
  EXPECT_GT(came, std::min(10.0, 2 * passed.count())) << passed.count() << " s";
  flown.press("F3");
  EXPECT_TRUE(flown.waitFor([](const json& s) { return share(s) == -1; }));
}

TEST(SplitWindow, theDividerIsDraggedByTheMouse) {
  // From the middle to a quarter: the line is where it was let go.
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown({"--set", "view.split.subject=land", "--set", "quality=low"});
  flown.press("F3");
  ASSERT_TRUE(flown.waitFor([](const json& s) { return s.contains("split"); }));
  const auto isLineAt = [](const core::Image& picture, int x) {  // to two pixels: those of the pointer
    const auto isWhite = [&](int at) {
      const auto* pixel = picture.pixel(at, 80);
      return pixel[0] == 255 && pixel[1] == 255 && pixel[2] == 255;
    };
    return isWhite(x - 2) || isWhite(x - 1) || isWhite(x) || isWhite(x + 1) || isWhite(x + 2);
  };
  ASSERT_TRUE(flown.waitForPicture([&](const core::Image& p) { return isLineAt(p, 320); }));
  flown.moveMouse(320, 180);
  flown.clickMouse("mousedown");
  flown.moveMouse(240, 180);
  flown.moveMouse(160, 180);
  EXPECT_TRUE(flown.waitForPicture([&](const core::Image& p) { return isLineAt(p, 160); }));
  flown.clickMouse("mouseup");
  flown.moveMouse(400, 180);
  EXPECT_TRUE(flown.waitForPicture([&](const core::Image& p) { return isLineAt(p, 160); }));
}

}  // namespace
}  // namespace skydrop::test
