// The program as a process: exit codes, and one clear line for everything that is wrong.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "support/paths.h"
#include "support/process.h"
#include "support/shared_noise.h"
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
      {"render", "--out", out, "--set", "clouds.coverage=2"},
      {"render", "--out", out, "--set", "clouds.tier=best"},
      {"simulate", "--seconds", "many"},
      {"accuracy", "nothing-of-this-name"},
      {"noise", "--format", "bmp"},
      {"noise", "--check", "--noise", out},
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
      {{"noise", "--noise", broken}, "magic number"},
      {{"noise", "--noise", "/nowhere/a.dds"}, "/nowhere/a.dds"},
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

TEST(Program, noiseIsMadeOnceAndKept) {
  // The second run reads what the first has made; a damaged file is said and made again; exports read back.
  const TemporaryFolder folder;
  const std::string cache = folder.path() / "cache", out = folder.path() / "out";
  const auto noise = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {test::programFile(), "noise"});
    return runProcess(words, {"XDG_CACHE_HOME=" + cache});
  };
  const ProcessResult first = noise({"--out", out, "--format", "dds"});
  EXPECT_EQ(first.exitCode, 0) << first.err;
  EXPECT_EQ(first.out.find("from the cache"), std::string::npos) << first.out;
  EXPECT_EQ(noise({}).out.find("made"), std::string::npos);
  EXPECT_EQ(noise({"--noise", out + "/shape.dds"}).out.find(out + "/shape.dds: 128x128x128 rgba8"), 0u);
  const auto detail = std::filesystem::path(cache) / "skydrop" / "detail-1-0.noise";
  std::filesystem::resize_file(detail, 1000);
  const ProcessResult damaged = noise({});
  EXPECT_EQ(damaged.exitCode, 0);
  EXPECT_TRUE(isOneLine(damaged));
  EXPECT_NE(damaged.err.find(detail.string() + ": damaged"), std::string::npos) << damaged.err;
  EXPECT_EQ(noise({}).err, "");
}

TEST(Program, aSceneWithCloudsGetsTheirNoiseAndOthersDoNot) {
  // What the cache has not is made and kept; a damaged file is said in one line; without clouds nothing is
  // looked for.
  const TemporaryFolder folder;
  const std::filesystem::path cache = folder.path() / "cache" / "skydrop";
  const auto frameOf = [&](const std::string& scene) {
    return runProcess({test::programFile(), "render", "--scene", scene, "--size", "64x36", "--set",
                       "streaming.viewDistanceM=2000", "--out", (folder.path() / "a.png").string()},
                      {"XDG_CACHE_HOME=" + (folder.path() / "cache").string()});
  };
  EXPECT_EQ(frameOf("terrain").exitCode, 0);
  EXPECT_FALSE(std::filesystem::exists(cache));
  copySharedNoise(cache);
  const std::filesystem::path weather = cache / "weather-1-0.noise";
  ASSERT_TRUE(std::filesystem::remove(weather));
  const ProcessResult first = frameOf("clear");
  EXPECT_EQ(first.exitCode, 0);
  EXPECT_EQ(first.err, "");
  ASSERT_TRUE(std::filesystem::exists(weather));
  std::filesystem::resize_file(weather, 100);
  const ProcessResult damaged = frameOf("overcast");
  EXPECT_EQ(damaged.exitCode, 0);
  EXPECT_TRUE(isOneLine(damaged));
  EXPECT_NE(damaged.err.find(weather.string() + ": damaged"), std::string::npos) << damaged.err;
  EXPECT_EQ(frameOf("fair").err, "");
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
