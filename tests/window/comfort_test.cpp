// The window itself: where it opens, how fast it draws, what is kept, and what is shown first.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <string>

#include "support/paths.h"
#include "window/flown_game.h"

namespace skydrop::test {
namespace {

using nlohmann::json;

FlownGame::Condition hasSize(int width, int height) {
  return [=](const json& s) {
    return s.at("window").at("width") == width && s.at("window").at("height") == height;
  };
}

void end(FlownGame& flown) {
  flown.process().askToEnd();
  EXPECT_EQ(flown.process().wait(60), 0) << flown.log();
}

json readJson(const std::filesystem::path& path) {
  std::ifstream file(path);
  return json::parse(file, nullptr, false);
}

std::ptrdiff_t timesIn(const std::string& text, const std::string& words) {
  std::ptrdiff_t count = 0;
  for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++count;
  return count;
}

TEST(WindowMemory, theWindowComesBackAsItWasLeft) {
  // A software renderer opens small and says so in one line; then the size that the player gave it, and the
  // screen that it filled. Only what differs is in the file.
  SKIP_WITHOUT_DISPLAY();
  const TemporaryFolder user;
  {
    FlownGame flown(FlownGame::Launch{.sized = false, .userFolder = user.path()});
    EXPECT_TRUE(flown.waitFor(hasSize(640, 360))) << flown.window();
    EXPECT_EQ(flown.window().at("quality"), "low");
    EXPECT_EQ(timesIn(flown.log(), "quality low"), 1) << flown.log();
    flown.resize(500, 301);
    EXPECT_TRUE(flown.waitFor(hasSize(500, 301)));
    end(flown);
  }
  const json kept = readJson(user.path() / "window.json").at("settings");
  EXPECT_EQ(kept, json({{"width", 500}, {"height", 301}, {"knowsSoftware", true}}));
  {
    FlownGame flown(FlownGame::Launch{.sized = false, .userFolder = user.path()});
    EXPECT_TRUE(flown.waitFor(hasSize(500, 301))) << flown.window();
    flown.press("alt+Return");
    EXPECT_TRUE(flown.waitFor(hasSize(FlownGame::kDisplayWidth, FlownGame::kDisplayHeight)))
        << flown.window();
    end(flown);
  }
  {
    FlownGame flown(FlownGame::Launch{.sized = false, .userFolder = user.path()});
    EXPECT_TRUE(flown.waitFor(hasSize(FlownGame::kDisplayWidth, FlownGame::kDisplayHeight)))
        << flown.window();
    flown.press("F11");
    EXPECT_TRUE(flown.waitFor(hasSize(500, 301))) << flown.window();
  }
}

TEST(WindowMemory, aWindowIsHeldToItsScreen) {
  // What another screen remembered: larger than this one, or beside it. It opens within this one, and what is
  // remembered stays for the other.
  SKIP_WITHOUT_DISPLAY();
  const TemporaryFolder user;
  const json remembered = {
      {"width", 3840}, {"height", 2160}, {"moved", true}, {"left", 5000}, {"top", -3000}};
  user.write("window.json", json({{"schema", 1}, {"settings", remembered}}).dump());
  {
    FlownGame flown(
        FlownGame::Launch{.words = {"--scene", "empty"}, .sized = false, .userFolder = user.path()});
    EXPECT_TRUE(flown.waitFor(hasSize(FlownGame::kDisplayWidth, FlownGame::kDisplayHeight)))
        << flown.window();
    const core::Image shown = flown.shown();
    EXPECT_EQ(shown.width, FlownGame::kDisplayWidth) << "none of it lies beside the screen";
    EXPECT_EQ(shown.height, FlownGame::kDisplayHeight);
    end(flown);
  }
  const json kept = readJson(user.path() / "window.json").at("settings");
  for (const auto& [name, value] : remembered.items()) EXPECT_EQ(kept.at(name), value) << name;
  FlownGame flown(FlownGame::Launch{.words = {"--scene", "empty", "--size", "3000x500"}, .sized = false});
  EXPECT_TRUE(flown.waitFor(hasSize(FlownGame::kDisplayWidth, 500))) << flown.window();
  EXPECT_EQ(timesIn(flown.log(), "--size 3000x500: the screen has room for 800x500"), 1) << flown.log();
}

TEST(WindowMemory, aFolderThatCannotBeWrittenIsSaidInOneLineAndTheFlightEndsWell) {
  SKIP_WITHOUT_DISPLAY();
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "");  // a folder cannot be made in a file
  FlownGame flown(FlownGame::Launch{.words = {"--scene", "empty"}, .userFolder = file + "/user"});
  flown.press("m");
  flown.press("F1");
  ASSERT_TRUE(flown.waitFor([](const json& s) { return s.at("window").at("menuOpen").get<bool>(); }));
  flown.press("F1");
  ASSERT_TRUE(flown.waitFor([](const json& s) { return !s.at("window").at("menuOpen").get<bool>(); }));
  end(flown);
  EXPECT_EQ(timesIn(flown.log(), file), 1) << flown.log();
}

TEST(FrameRate, aCapMakesFramesEven) {
  // 20 Hz on a scene that draws far faster: the median interval is the period, to a millisecond.
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown({"--scene", "empty", "--set", "view.frameCapHz=20"});
  ASSERT_TRUE(flown.waitFor([](const json& s) { return s.at("frame").at("count").get<int>() > 60; }));
  EXPECT_NEAR(flown.window().at("intervalMs").at("median").get<double>(), 50, 1);
}

TEST(FrameRate, aWindowThatNobodySeesDrawsNothingAndPauses) {
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown({"--scene", "empty"});
  flown.hide();
  ASSERT_TRUE(flown.waitFor([](const json& s) { return s.at("window").at("hidden").get<bool>(); }));
  const json hidden = flown.statistics();
  EXPECT_TRUE(hidden.at("window").at("paused").get<bool>());
  flown.unhide();
  ASSERT_TRUE(flown.waitFor([](const json& s) { return !s.at("window").at("hidden").get<bool>(); }));
  // Statistics are written twice a second: at most that long it drew before the last ones, and after these.
  EXPECT_EQ(flown.statistics().at("steps"), hidden.at("steps"));
}

TEST(Loading, aPictureComesBeforeTheLandAndTimeAfterIt) {
  // The first picture is there long before the game; then no patch is drawn coarser than it should be.
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown;
  const json window = flown.window();
  EXPECT_GT(window.at("firstPictureMs").get<double>(), 0);
  // Half a second on an idle machine (docs/menu-and-hud.md has the figures); this one may be shared.
  EXPECT_LT(window.at("firstPictureMs").get<double>(), 3000);
  EXPECT_LT(window.at("firstPictureMs").get<double>(), window.at("loadedMs").get<double>());
  EXPECT_GT(flown.statistics().at("terrain").at("generated").get<int>(), 0);
}

TEST(Loading, noShaderIsCompiledOnceTheFlightHasBegun) {
  // In the default scene, ten seconds with a package in the air and on the ground, from all cameras, with
  // every menu open, at noon: each program was there when the first frame was drawn.
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown({"--scene", "fair"});
  const auto steps = [](const json& s) { return s.at("steps").get<int>(); };
  flown.press("space");
  for (const char* key : {"c", "c", "c", "h", "h", "F1", "F1", "Escape", "Escape"}) {
    const int before = steps(flown.statistics());
    flown.press(key);
    ASSERT_TRUE(flown.waitFor([&](const json& s) { return steps(s) > before + 30 || key[0] == 'E'; })) << key;
  }
  ASSERT_TRUE(flown.waitFor([](const json& s) { return !s.at("window").at("paused").get<bool>(); }));
  ASSERT_TRUE(flown.waitFor([&](const json& s) { return steps(s) > 1200 && s.at("game").at("drops") == 1; }))
      << flown.statistics().dump();
  EXPECT_EQ(flown.statistics().at("gl").at("programs"), flown.window().at("programsLoaded"));
}

TEST(Loading, aSceneWithCloudsWaitsForTheirNoise) {
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown({"--scene", "fair"});
  const json effects = flown.statistics().at("effects");
  EXPECT_NE(std::find(effects.begin(), effects.end(), "clouds"), effects.end()) << effects;
  EXPECT_EQ(timesIn(flown.log(), "noise"), 0) << flown.log();
}

TEST(Loading, thePictureFillsAWindowThatIsResized) {
  // While the noise of an empty cache is made, the window grows: the loading picture reaches its corners.
  SKIP_WITHOUT_DISPLAY();
  const TemporaryFolder folder;
  const std::string log = (folder.path() / "log").string();
  VirtualDisplay display(FlownGame::kDisplayWidth, FlownGame::kDisplayHeight, log);
  BackgroundProcess game(
      {test::programFile(), "--scene", "fair", "--user-dir", (folder.path() / "user").string()},
      {"DISPLAY=" + display.name(), "WAYLAND_DISPLAY", "LIBGL_ALWAYS_SOFTWARE=1",
       "XDG_CACHE_HOME=" + folder.path().string()},
      log);
  const std::string window = display.xdotool({"search", "--sync", "--name", "^Skydrop$"});
  constexpr int kGrownWidth = 780, kGrownHeight = 570;
  display.xdotool({"windowsize", window, std::to_string(kGrownWidth), std::to_string(kGrownHeight)});
  const auto isColour = [](const std::uint8_t* pixel, int red, int green, int blue) {
    return std::abs(pixel[0] - red) <= 3 && std::abs(pixel[1] - green) <= 3 && std::abs(pixel[2] - blue) <= 3;
  };
  bool filled = false;
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!filled && game.isRunning() && std::chrono::steady_clock::now() < deadline) {
    const core::Image shown = display.picture(window);
    if (shown.width != kGrownWidth || shown.height != kGrownHeight) continue;
    const std::uint8_t* sky = shown.pixel(kGrownWidth - 1, 0);
    const std::uint8_t* ground = shown.pixel(kGrownWidth - 1, kGrownHeight - 1);
    filled = isColour(sky, 38, 84, 138) && isColour(ground, 38, 52, 50);  // ui/loading_picture.cpp
  }
  EXPECT_TRUE(filled);
}

TEST(Loading, quittingWhileTheNoiseIsMadeIsPrompt) {
  // With an empty cache the shape alone takes more than a second: asked to end as soon as the window is
  // there, the program ends well and has not waited for it.
  SKIP_WITHOUT_DISPLAY();
  const TemporaryFolder folder;
  const std::string log = (folder.path() / "log").string();
  VirtualDisplay display(FlownGame::kDisplayWidth, FlownGame::kDisplayHeight, log);
  BackgroundProcess game(
      {test::programFile(), "--scene", "fair", "--user-dir", (folder.path() / "user").string()},
      {"DISPLAY=" + display.name(), "WAYLAND_DISPLAY", "LIBGL_ALWAYS_SOFTWARE=1",
       "XDG_CACHE_HOME=" + folder.path().string()},
      log);
  display.xdotool({"search", "--sync", "--name", "^Skydrop$"});
  game.askToEnd();
  EXPECT_EQ(game.wait(60), 0);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "skydrop"));
}

}  // namespace
}  // namespace skydrop::test
