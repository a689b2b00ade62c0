// The briefing before the first flight, and a drop that is seen.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "support/process.h"
#include "support/temporary_folder.h"
#include "window/flown_game.h"

namespace skydrop::test {
namespace {

using nlohmann::json;

bool isPaused(const json& s) { return s.at("window").at("paused").get<bool>(); }

TEST(DeliveryWindow, theBriefingHoldsTheFirstFlightUntilAKeyAndDoesNotComeAgain) {
  // With the picture of the package it is asked for by a row each: without, the flight begins at once.
  SKIP_WITHOUT_DISPLAY();
  const TemporaryFolder user;
  const FlownGame::Launch launch{
      .words = {"--set", "view.briefing=true"}, .sized = false, .userFolder = user.path()};
  {
    FlownGame flown(launch);
    ASSERT_TRUE(flown.waitFor(isPaused)) << "the briefing is shown";
    EXPECT_EQ(flown.statistics().at("steps"), 0);
    flown.press("w");
    ASSERT_TRUE(flown.waitFor([](const json& s) { return !isPaused(s) && s.at("steps") > 0; }));
    flown.process().askToEnd();
    ASSERT_EQ(flown.process().wait(60), 0) << flown.log();
  }
  std::ifstream file(user.path() / "window.json");
  EXPECT_EQ(json::parse(file).at("settings").at("knowsBriefing"), true);
  FlownGame again(launch);
  EXPECT_TRUE(again.waitFor([](const json& s) { return !isPaused(s) && s.at("steps") > 0; }));
}

TEST(DeliveryWindow, aPackageIsSeenInASmallPictureAndRiddenWith) {
  // Space drops: within the picture's place the window shows something else than the sky there; V rides, and
  // the whole picture changes; the aircraft flies on.
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown({"--set", "view.dropView=picture"});
  const core::Image before = flown.screenshot();
  flown.press("space");
  ASSERT_TRUE(flown.waitFor([](const json& s) { return s.at("game").at("drops") == 1; }));
  const auto differs = [&](const core::Image& picture) {
    int count = 0;
    for (int y = 40; y < 100; ++y)
      for (int x = 490; x < 620; ++x) {
        for (int c = 0; c < 3; ++c) {
          if (std::abs(picture.pixel(x, y)[c] - before.pixel(x, y)[c]) > 24) {
            ++count;
            break;
          }
        }
      }
    return count > 130 * 60 / 3;
  };
  EXPECT_TRUE(flown.waitForPicture(differs));
  flown.press("v");
  const json riding = flown.statistics();
  EXPECT_TRUE(
      flown.waitFor([&](const json& s) { return s.at("steps") > riding.at("steps").get<int>() + 120; }));
  flown.press("v");
  flown.press("j");
  EXPECT_TRUE(
      flown.waitFor([&](const json& s) { return s.at("steps") > riding.at("steps").get<int>() + 240; }));
}

TEST(DeliveryWindow, aFlightBeginsWithTheTargetAheadAndItsLogReplays) {
  // The scene points east, the first target lies at 286 degrees; the log says so, and headless it flies the
  // same. The lesson begins where its scene says, with something to learn.
  SKIP_WITHOUT_DISPLAY();
  const TemporaryFolder folder;
  const std::string log = (folder.path() / "flight.log").string();
  {
    FlownGame flown({"--record", log});
    const auto heading = [](const json& s) { return s.at("game").at("heading").get<double>(); };
    EXPECT_NEAR(heading(flown.statistics()), 285.7, 3);
    ASSERT_TRUE(flown.waitFor([](const json& s) { return s.at("steps") > 240; }));
    flown.process().askToEnd();
    ASSERT_EQ(flown.process().wait(60), 0) << flown.log();
    const ProcessResult replay = runSkydrop({"simulate", "--replay", log, "--seconds", "600"});
    EXPECT_EQ(replay.exitCode, 0) << replay.err;
    EXPECT_NE(replay.out.find(flown.statistics().at("stateHash").get<std::string>()), std::string::npos);
  }
  FlownGame lesson({"--scene", "lesson", "--no-effect", "clouds"});
  EXPECT_NEAR(lesson.statistics().at("game").at("heading").get<double>(), 200, 5);
}

}  // namespace
}  // namespace skydrop::test
