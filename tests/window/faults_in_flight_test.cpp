// What breaks under the program while it flies: sound, graphics, window and clock. Each is one line at most,
// and nothing is lost (docs/failures.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "skydrop/core/file.h"
#include "skydrop/core/image.h"
#include "support/paths.h"
#include "support/process.h"
#include "window/flown_game.h"

namespace skydrop::test {
namespace {

using nlohmann::json;

std::uint64_t stepsOf(const json& statistics) { return statistics.at("steps").get<std::uint64_t>(); }

class FaultsInFlight : public testing::Test {
 protected:
  FlownGame::Launch launch(std::vector<std::string> words = {}) const {
    return {.words = std::move(words), .environment = environment()};
  }
  std::vector<std::string> environment() const {
    return {"LD_PRELOAD=" + binaryDir() + "/tests/libskydrop_faults.so",
            "SKYDROP_FAULTS=" + folder_.path().string(), "ALSOFT_DRIVERS=null"};
  }
  void begin(const char* fault) const { std::ofstream(folder_.path() / fault) << ""; }
  void end(const char* fault) const { std::filesystem::remove(folder_.path() / fault); }

  static bool fliesOn(FlownGame& flown) {
    const std::uint64_t now = stepsOf(flown.statistics());
    return flown.waitFor([now](const json& s) { return stepsOf(s) > now + 60; });
  }
  static std::size_t linesWith(const FlownGame& flown, const std::string& words) {
    const std::string log = flown.log();
    std::size_t count = 0;
    for (std::size_t at = log.find(words); at != std::string::npos; at = log.find(words, at + 1)) ++count;
    return count;
  }

  TemporaryFolder folder_;
};

TEST_F(FaultsInFlight, aSoundDeviceThatGoesAwayIsReplacedByAnother) {
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown(launch());
  ASSERT_EQ(linesWith(flown, "sound device"), 0u) << flown.log();
  begin("sound");
  EXPECT_TRUE(flown.waitFor([&](const json&) {
    return linesWith(flown, "the sound device is gone: sound goes on through") == 1;
  })) << flown.log();
  EXPECT_TRUE(fliesOn(flown));
  EXPECT_EQ(linesWith(flown, "sound device"), 1u) << flown.log();
  flown.process().askToEnd();
  EXPECT_EQ(flown.process().wait(60), 0) << flown.log();
}

TEST_F(FaultsInFlight, withoutAnotherSoundDeviceTheFlightIsSilent) {
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown(launch());
  begin("noSound");
  EXPECT_TRUE(flown.waitFor([&](const json&) {
    return linesWith(flown, "the sound device is gone: no sound device: the game is silent") == 1;
  })) << flown.log();
  EXPECT_TRUE(fliesOn(flown));
  flown.press("space");  // has a sound
  EXPECT_TRUE(fliesOn(flown));
  EXPECT_EQ(linesWith(flown, "the sound device is gone"), 1u) << flown.log();
  flown.process().askToEnd();
  EXPECT_EQ(flown.process().wait(60), 0) << flown.log();
}

TEST_F(FaultsInFlight, aGraphicsDeviceThatIsLostEndsTheFlightWithAllOfItKept) {
  // One line, exit code 3; the record ends with the last step, and the player's choices are written.
  SKIP_WITHOUT_DISPLAY();
  const std::string log = (folder_.path() / "flight.log").string();
  FlownGame flown(launch({"--record", log}));
  flown.press("m");  // mute: a choice that is kept
  ASSERT_TRUE(fliesOn(flown));
  begin("reset");
  EXPECT_EQ(flown.process().wait(60), 3) << flown.log();
  EXPECT_EQ(linesWith(flown, "OpenGL: the driver has lost the graphics device\n"), 1u) << flown.log();
  EXPECT_EQ(linesWith(flown, "OpenGL"), 1u) << flown.log();
  const ProcessResult replay = runSkydrop({"simulate", "--replay", log});
  EXPECT_EQ(replay.exitCode, 0) << replay.err;
  EXPECT_EQ(replay.err, "");
  EXPECT_NE(replay.out.find(flown.statistics().at("stateHash").get<std::string>()), std::string::npos)
      << replay.out;
  EXPECT_NE(core::readTextFile(flown.userFolder() / "settings.json").find("mute"), std::string::npos);
}

TEST_F(FaultsInFlight, aDriverWithoutMemoryIsOneLineAndTheFlightGoesOn) {
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown(launch());
  begin("memory");
  EXPECT_TRUE(flown.waitFor([&](const json&) {
    return linesWith(flown, "OpenGL: frame: the driver has run out of memory") == 1;
  })) << flown.log();
  EXPECT_TRUE(fliesOn(flown));
  EXPECT_EQ(linesWith(flown, "out of memory"), 1u) << flown.log();
  flown.process().askToEnd();
  EXPECT_EQ(flown.process().wait(60), 0) << flown.log();
}

TEST_F(FaultsInFlight, framesWithoutAWindowEndWithALostDevice) {
  // One line, exit code 3; the frames before it are whole.
  const auto path = [&](const char* name) { return (folder_.path() / name).string(); };
  BackgroundProcess render({programFile(), "render", "--backend", "egl", "--scene", "terrain", "--size",
                            "64x36", "--frames", "400", "--fps", "60", "--out", path("frame%d.png")},
                           environment(), path("log"));
  for (int i = 0; i < 3000 && !std::filesystem::exists(path("frame2.png")); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  ASSERT_TRUE(std::filesystem::exists(path("frame2.png")));
  begin("reset");
  EXPECT_EQ(render.wait(60), 3);
  const std::string log = core::readTextFile(path("log"));
  EXPECT_NE(log.find("OpenGL: the driver has lost the graphics device\n"), std::string::npos) << log;
  EXPECT_EQ(core::readPng(path("frame2.png")).width, 64);
}

TEST_F(FaultsInFlight, aWindowOfOnePixelAndOfNoneFliesOn) {
  // And draws its picture again once it has a size.
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown(launch());
  const auto hasSize = [](int width, int height) {
    return [=](const json& s) {
      return s.at("window").at("width") == width && s.at("window").at("height") == height;
    };
  };
  flown.resize(1, 1);
  EXPECT_TRUE(flown.waitFor(hasSize(1, 1))) << flown.window().dump();
  EXPECT_TRUE(fliesOn(flown)) << flown.log();
  EXPECT_EQ(flown.screenshot().width, 1);
  begin("zero");
  EXPECT_TRUE(fliesOn(flown)) << flown.log();
  flown.press("F1");
  EXPECT_TRUE(flown.waitFor([](const json& s) { return s.at("window").at("menuOpen") == true; }));
  EXPECT_TRUE(fliesOn(flown)) << flown.log();
  flown.press("F1");
  end("zero");
  flown.resize(500, 301);
  EXPECT_TRUE(flown.waitFor(hasSize(500, 301))) << flown.window().dump();
  EXPECT_EQ(flown.screenshot().height, 301);
  EXPECT_EQ(flown.window().at("fault"), "");
  flown.process().askToEnd();
  EXPECT_EQ(flown.process().wait(60), 0) << flown.log();
}

TEST_F(FaultsInFlight, aClockOnTheWallThatJumpsYearsBackAndForthChangesNothing) {
  SKIP_WITHOUT_DISPLAY();
  const std::string log = (folder_.path() / "flight.log").string();
  FlownGame::Launch silent = launch({"--record", log});
  silent.environment
      .pop_back();  // OpenAL's device that is none mixes by this clock, and would mix all the years
  FlownGame flown(std::move(silent));
  begin("clock");
  ASSERT_TRUE(fliesOn(flown));
  EXPECT_EQ(flown.screenshot().width, FlownGame::kWidth);
  end("clock");
  ASSERT_TRUE(fliesOn(flown));
  begin("clock");
  ASSERT_TRUE(fliesOn(flown));
  flown.process().askToEnd();
  ASSERT_EQ(flown.process().wait(60), 0) << flown.log();
  const ProcessResult replay = runSkydrop({"simulate", "--replay", log});
  EXPECT_EQ(replay.exitCode, 0) << replay.err;
  EXPECT_NE(replay.out.find(flown.statistics().at("stateHash").get<std::string>()), std::string::npos)
      << replay.out;
}

}  // namespace
}  // namespace skydrop::test
