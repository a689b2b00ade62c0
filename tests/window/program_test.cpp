// The program as a process: exit codes, and one clear line for everything that is wrong.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "support/process.h"
#include "support/temporary_folder.h"

namespace skydrop::test {
namespace {

// One line that starts with the program's name.
testing::AssertionResult isOneLine(const ProcessResult& result) {
  const auto lines = std::count(result.err.begin(), result.err.end(), '\n');
  if (lines == 1 && result.err.starts_with("skydrop: ")) return testing::AssertionSuccess();
  return testing::AssertionFailure() << lines << " lines: " << result.err;
}

TEST(Program, usageErrorsExitWithTwoAndOneLine) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "a.png").string();
  const std::vector<std::vector<std::string>> wrong = {
      {"--fast"},
      {"dance"},
      {"render", "--out", out, "--size", "0x0"},
      {"render", "--out", out, "--pose", "1,2"},
      {"render", "--out", out, "--set", "aircraft.rollFactr=1"},
      {"render", "--out", out, "--set", "aircraft.rollFactor=1e9"},
      {"render", "--out", out, "--set", "aircraft.rollFactor=nan"},
      {"render", "--out", out, "--set", "aircraft.rollFactor"},
      {"simulate", "--seconds", "many"},
      {"accuracy", "nothing-of-this-name"},
  };
  for (const auto& words : wrong) {
    const ProcessResult result = runSkydrop(words);
    EXPECT_EQ(result.exitCode, 2) << words.back();
    EXPECT_TRUE(isOneLine(result)) << words.back();
    EXPECT_EQ(result.out, "") << words.back();
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << "something was written";
}

TEST(Program, badDataExitsWithOneAndNamesTheFile) {
  const TemporaryFolder folder;
  const std::string broken = folder.write("broken.json", "{\"schema\": 1, ");
  const std::string wrongSetting =
      folder.write("setting.json", R"({"schema": 1, "settings": {"aircraft": {"rollFactor": -7}}})");
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong = {
      {{"simulate", "--scene", broken}, broken},
      {{"simulate", "--scene", wrongSetting}, "aircraft.rollFactor"},
      {{"simulate", "--scene", "nowhere"}, "nowhere"},
      {{"simulate", "--scene", "/nowhere/a.json"}, "/nowhere/a.json"},
      {{"simulate", "--replay", broken}, broken},
      {{"simulate", "--replay", "/nowhere/a.log"}, "/nowhere/a.log"},
      {{"simulate", "--seconds", "1", "--stats", "/nowhere/s.json"}, "/nowhere/s.json"},
      {{"render", "--scene", "empty", "--out", "/nowhere/a.png"}, "/nowhere/a.png"},
  };
  for (const auto& [words, named] : wrong) {
    const ProcessResult result = runSkydrop(words);
    EXPECT_EQ(result.exitCode, 1) << named;
    EXPECT_TRUE(isOneLine(result)) << named;
    EXPECT_NE(result.err.find(named), std::string::npos) << result.err;
  }
}

TEST(Program, withoutADisplayItNamesRenderAndExitsWithThree) {
  const ProcessResult result = runSkydrop({});
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_TRUE(isOneLine(result));
  EXPECT_NE(result.err.find("skydrop render"), std::string::npos) << result.err;
}

TEST(Program, questionsAreAnsweredOnStandardOutput) {
  for (const char* question : {"--help", "--version", "--list-scenes"}) {
    const ProcessResult result = runSkydrop({question});
    EXPECT_EQ(result.exitCode, 0) << question;
    EXPECT_EQ(result.err, "") << question;
    EXPECT_NE(result.out, "") << question;
  }
}

TEST(Program, theSameFlightHasTheSameStateWhateverTheFrameRateAndTheWorkers) {
  const auto flight = [](const char* fps, const char* workers) {
    return runSkydrop({"simulate", "--autopilot", "--seconds", "20", "--fps", fps, "--workers", workers}).out;
  };
  const std::string state = flight("60", "1");
  EXPECT_NE(state.find("state "), std::string::npos) << state;
  EXPECT_EQ(flight("30", "4"), state);
  EXPECT_EQ(flight("144", "2"), state);
}

}  // namespace
}  // namespace skydrop::test
