// Records of flights outlive whatever ends the program, and say what they are worth when they are flown
// again.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "skydrop/core/file.h"
#include "skydrop/game/input_log.h"
#include "skydrop/scene/scene.h"
#include "support/process.h"
#include "window/flown_game.h"

namespace skydrop::test {
namespace {

using nlohmann::json;

constexpr std::uint64_t kSecond = 120;  // steps

FlownGame::Condition stepsBeyond(std::uint64_t steps) {
  return [steps](const json& s) { return s.at("steps").get<std::uint64_t>() > steps; };
}

std::uint64_t stepsOf(const json& statistics) { return statistics.at("steps").get<std::uint64_t>(); }

ProcessResult replay(const std::string& log) { return runSkydrop({"simulate", "--replay", log}); }

std::ptrdiff_t lines(const std::string& text) { return std::ranges::count(text, '\n'); }

void replaceIn(const std::string& file, const std::string& what, const std::string& with) {
  std::string text = core::readTextFile(file);
  const auto at = text.find(what);
  ASSERT_NE(at, std::string::npos) << what;
  std::ofstream(file) << text.replace(at, what.size(), with);
}

// A flying game that records, with the throttle pulled for part of it.
struct RecordingGame {
  explicit RecordingGame(std::vector<std::string> words = {}) {
    words.insert(words.end(), {"--record", log});
    flown.emplace(words);
    flown->hold("w");
    flew = flown->waitFor(stepsBeyond(kSecond));
    flown->release("w");
    flew = flew && flown->waitFor(stepsBeyond(3 * kSecond));
  }

  TemporaryFolder folder;
  std::string log = (folder.path() / "flight.log").string();
  std::optional<FlownGame> flown;
  bool flew = false;
};

TEST(Records, aKilledGameLeavesALogUpToTheLastSecond) {
  // SIGKILL in flight: the log replays without a difference and lacks at most a second of what was flown.
  SKIP_WITHOUT_DISPLAY();
  RecordingGame game;
  ASSERT_TRUE(game.flew);
  const std::uint64_t seen = stepsOf(game.flown->statistics());
  game.flown->process().send(SIGKILL);
  EXPECT_EQ(game.flown->process().wait(60), 128 + SIGKILL);
  const game::InputLog log = game::readInputLog(game.log);
  EXPECT_FALSE(log.ended);
  EXPECT_GE(log.stepCount() + kSecond, seen);
  EXPECT_TRUE(std::ranges::any_of(log.runs, [](const auto& run) { return run.controls.thrust > 0; }));
  const ProcessResult again = replay(game.log);
  EXPECT_EQ(again.exitCode, 0) << again.err;
  EXPECT_NE(again.err.find(game.log + ": the recording was cut off after "), std::string::npos) << again.err;
  EXPECT_EQ(lines(again.err), 1) << again.err;
}

TEST(Records, aClosedTerminalEndsTheFlightInOrder) {
  // SIGHUP as SIGTERM: exit code 0, and the log ends with the state that the statistics show.
  SKIP_WITHOUT_DISPLAY();
  RecordingGame game;
  ASSERT_TRUE(game.flew);
  game.flown->process().send(SIGHUP);
  EXPECT_EQ(game.flown->process().wait(60), 0) << game.flown->log();
  const game::InputLog log = game::readInputLog(game.log);
  EXPECT_TRUE(log.ended);
  EXPECT_EQ(log.stepCount(), stepsOf(game.flown->statistics()));
  const ProcessResult again = replay(game.log);
  EXPECT_EQ(again.exitCode, 0) << again.err;
  EXPECT_EQ(again.err, "");
  EXPECT_NE(again.out.find(game.flown->statistics().at("stateHash").get<std::string>()), std::string::npos);
}

TEST(Records, aDisplayThatGoesAwayLeavesAValidLog) {
  SKIP_WITHOUT_DISPLAY();
  RecordingGame game;
  ASSERT_TRUE(game.flew);
  const std::uint64_t seen = stepsOf(game.flown->statistics());
  game.flown->endDisplay();
  EXPECT_TRUE(game.flown->process().wait(60)) << "it goes on without a display";
  EXPECT_GE(game::readInputLog(game.log).stepCount() + kSecond, seen);
  const ProcessResult again = replay(game.log);
  EXPECT_EQ(again.exitCode, 0) << again.err;
}

TEST(Records, whatWouldBeginARecordingAnewIsRefusedByFile) {
  // The scene's file and the land in the player's file are written while a flight is recorded: both are
  // refused with a line, the flight goes on, and its log replays to the end with the scene that it began
  // with.
  SKIP_WITHOUT_DISPLAY();
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "my scenes");
  const std::string scene = (folder.path() / "my scenes" / "canyon.json").string();
  const std::string shipped = core::readTextFile(scene::loadScene("terrain").file);
  std::ofstream(scene) << shipped;
  RecordingGame game({"--scene", scene});
  ASSERT_TRUE(game.flew);
  const std::uint64_t before = stepsOf(game.flown->statistics());
  const auto says = [&](const std::string& line) {
    return game.flown->waitFor(
        [&](const json&) { return game.flown->log().find(line) != std::string::npos; });
  };
  std::ofstream(scene) << "{\"schema\": 1, \"seed\": 7, \"effects\": [\"terrain\", \"aircraft\"]}";
  EXPECT_TRUE(says("The scene stays as it was while a flight is recorded")) << game.flown->log();
  std::filesystem::create_directories(game.flown->userFolder());
  std::ofstream(game.flown->userFolder() / "settings.json")
      << R"({"schema": 1, "settings": {"terrain": {"plainHeight": 321}, "aircraft": {"rollFactor": 0.5}}})";
  EXPECT_TRUE(says("The land keeps its shape while a flight is recorded")) << game.flown->log();
  ASSERT_TRUE(game.flown->waitFor(stepsBeyond(before + kSecond)));
  game.flown->process().askToEnd();
  EXPECT_EQ(game.flown->process().wait(60), 0) << game.flown->log();
  const game::InputLog log = game::readInputLog(game.log);
  EXPECT_EQ(log.scene, (game::InputLog::SceneRecord{scene, shipped}));
  EXPECT_EQ(log.stepCount(), stepsOf(game.flown->statistics()));
  ASSERT_EQ(log.changes.size(), 1u);
  EXPECT_EQ(log.changes[0].setting, (game::SettingOverride{"aircraft.rollFactor", "0.5"}));
  const ProcessResult again = replay(game.log);
  EXPECT_EQ(again.exitCode, 0) << again.err;
  EXPECT_NE(again.err.find(scene + " has changed since"), std::string::npos) << again.err;
}

TEST(Records, aFullDiskIsSaidOnceAndTheFlightGoesOn) {
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown({"--record", "/dev/full"});
  ASSERT_TRUE(flown.waitFor(stepsBeyond(3 * kSecond)));
  flown.process().askToEnd();
  EXPECT_EQ(flown.process().wait(60), 1);
  const std::string said = flown.log();
  const auto at = said.find("skydrop: /dev/full: cannot write: ");
  EXPECT_NE(at, std::string::npos) << said;
  EXPECT_EQ(said.find("/dev/full", at + 40), std::string::npos) << said;
}

TEST(Records, aReplayInTheWindowSaysWhereItDiffers) {
  SKIP_WITHOUT_DISPLAY();
  const TemporaryFolder folder;
  const std::string log = (folder.path() / "flight.log").string();
  ASSERT_EQ(runSkydrop({"simulate", "--scene", "terrain", "--autopilot", "--seconds", "3", "--record", log})
                .exitCode,
            0);
  replaceIn(log, "[\"check\",120,", "[1]\n[\"check\",120,");
  FlownGame flown({"--replay", log});
  ASSERT_TRUE(flown.waitFor([&](const json&) {
    return flown.log().find(log + ": step 240 (2.000 s): the replay differs") != std::string::npos;
  })) << flown.log();
}

TEST(Records, simulateAndRenderRecordAndCompare) {
  // A flight of the autopilot recorded by either replays in either; a log that was tampered with gives one
  // line that names the first checkpoint that differs, the outputs, and exit code 1. A replay that is shorter
  // than its log compares what it reached.
  const TemporaryFolder folder;
  const auto file = [&](const char* name) { return (folder.path() / name).string(); };
  const std::vector<std::string> render = {"render", "--scene", "empty",      "--size",
                                           "64x36",  "--out",   file("a.png")};
  const auto with = [](std::vector<std::string> words, const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  const ProcessResult flown =
      runSkydrop({"simulate", "--autopilot", "--seconds", "5", "--record", file("simulated.log")});
  ASSERT_EQ(flown.exitCode, 0) << flown.err;
  const ProcessResult drawn = runSkydrop(with(render, {"--time", "2.5", "--record", file("rendered.log")}));
  ASSERT_EQ(drawn.exitCode, 0) << drawn.err;
  EXPECT_EQ(game::readInputLog(file("rendered.log")).stepCount(), 300u);
  const ProcessResult again = replay(file("simulated.log"));
  EXPECT_EQ(again.exitCode, 0);
  EXPECT_EQ(again.out, flown.out);
  EXPECT_EQ(again.err, "");
  const std::vector<std::string> redraw = {
      "render", "--replay", file("rendered.log"), "--size", "64x36", "--out", file("b.png"), "--time", "2.5"};
  EXPECT_EQ(runSkydrop(redraw).exitCode, 0);

  // A record is never replaced; recording a replay gives the same log again.
  const ProcessResult twice = runSkydrop({"simulate", "--autopilot", "--record", file("simulated.log")});
  EXPECT_EQ(twice.exitCode, 1);
  EXPECT_TRUE(twice.err.starts_with("skydrop: " + file("simulated.log") + ": cannot record: ")) << twice.err;
  EXPECT_EQ(lines(twice.err), 1);
  ASSERT_EQ(
      runSkydrop({"simulate", "--replay", file("simulated.log"), "--record", file("copy.log")}).exitCode, 0);
  EXPECT_EQ(core::readTextFile(file("copy.log")), core::readTextFile(file("simulated.log")));

  const auto tamper = [](const std::string& log, const std::string& check) {
    std::string text = core::readTextFile(log);
    char& digit = text[text.find("\"]", text.find(check)) - 1];
    digit = digit == '0' ? '1' : '0';
    std::ofstream(log) << text;
  };
  tamper(file("simulated.log"), "[\"check\",360,");
  tamper(file("simulated.log"), "[\"end\",");
  const ProcessResult differs = runSkydrop(
      {"simulate", "--replay", file("simulated.log"), "--stats", file("s.json"), "--trace", file("t.csv")});
  EXPECT_EQ(differs.exitCode, 1);
  EXPECT_NE(differs.err.find("simulated.log: step 360 (3.000 s): the replay differs"), std::string::npos)
      << differs.err;
  EXPECT_EQ(lines(differs.err), 1) << differs.err;
  EXPECT_EQ(differs.out, flown.out);
  EXPECT_TRUE(std::filesystem::exists(file("s.json")));
  EXPECT_EQ(lines(core::readTextFile(file("t.csv"))), 602);
  EXPECT_EQ(runSkydrop({"simulate", "--replay", file("simulated.log"), "--seconds", "2.9"}).exitCode, 0);
  tamper(file("rendered.log"), "[\"check\",240,");
  std::filesystem::remove(file("b.png"));
  const ProcessResult redrawn = runSkydrop(redraw);
  EXPECT_EQ(redrawn.exitCode, 1);
  EXPECT_NE(redrawn.err.find("step 240 (2.000 s)"), std::string::npos) << redrawn.err;
  EXPECT_TRUE(std::filesystem::exists(file("b.png")));
}

TEST(Records, aFullDiskUnderASimulationGivesOneLineAndExitCodeOne) {
  for (const std::string flag : {"--record", "--trace"}) {
    const ProcessResult result = runSkydrop({"simulate", "--seconds", "3", flag, "/dev/full"});
    EXPECT_EQ(result.exitCode, 1) << flag;
    EXPECT_TRUE(result.err.starts_with("skydrop: /dev/full: cannot write: ")) << result.err;
    EXPECT_EQ(lines(result.err), 1) << result.err;
    EXPECT_NE(result.out.find("3.000 s"), std::string::npos) << "the flight went on: " << result.out;
  }
}

}  // namespace
}  // namespace skydrop::test
