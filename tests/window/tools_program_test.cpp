// The verbs for scripts: compare and settings, as the program runs them.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "app/settings/settings.h"
#include "skydrop/core/file.h"
#include "skydrop/core/image.h"
#include "skydrop/core/settings_table.h"
#include "support/process.h"
#include "support/stats_schema.h"
#include "support/temporary_folder.h"

namespace skydrop::test {
namespace {

class ToolsProgram : public testing::Test {
 protected:
  // A grey picture of 8 x 4 pixels, one of which may be another grey.
  std::string picture(const std::string& name, int grey, int odd, int width = 8) {
    core::Image image(width, 4);
    for (std::size_t i = 0; i < image.rgba.size(); ++i)
      image.rgba[i] = static_cast<std::uint8_t>(i % 4 == 3 ? 255 : grey);
    for (int c = 0; c < 3; ++c) image.pixel(5, 2)[c] = static_cast<std::uint8_t>(odd);
    const std::string path = (folder_.path() / name).string();
    core::writePng(path, image);
    return path;
  }

  TemporaryFolder folder_;
};

TEST_F(ToolsProgram, compareTellsHowFarPicturesDiffer) {
  // One of 32 pixels by 20 in three of its four channels: 20 * 3 / 128 in the mean.
  const std::string a = picture("a.png", 100, 100), b = picture("b.png", 100, 120);
  const ProcessResult same = runSkydrop({"compare", a, a, "--max", "0", "--mean", "0", "--flip", "0"});
  EXPECT_EQ(same.exitCode, 0) << same.err;
  EXPECT_EQ(same.out, "0 of 32 pixels differ, by 0 of 255 at most and 0 in the mean; mean FLIP 0\n");

  const std::string out = (folder_.path() / "difference").string();
  const ProcessResult differs = runSkydrop({"compare", a, b, "--json", "--out", out});
  ASSERT_EQ(differs.exitCode, 0) << differs.err;
  const auto report = nlohmann::json::parse(differs.out);
  EXPECT_EQ(report.at("differingPixels"), 1);
  EXPECT_EQ(report.at("largest"), 20);
  EXPECT_EQ(report.at("mean"), 20 * 3 / 128.0);
  EXPECT_GT(report.at("flip"), 0);
  EXPECT_EQ(report.at("isWithinLimits"), true);
  // The difference is stretched to white, where it is.
  const core::Image difference = core::readPng(out + "/difference.png");
  EXPECT_EQ(int{difference.pixel(5, 2)[0]}, 255);
  EXPECT_EQ(int{difference.pixel(4, 2)[0]}, 0);
  EXPECT_EQ(core::readPng(out + "/flip.png").width, 8);
}

TEST_F(ToolsProgram, aPictureSaysHowItIsMadeAgain) {
  const std::string a = (folder_.path() / "a.png").string(), b = (folder_.path() / "b.png").string();
  const std::vector<std::string> flight = {"render",      "--scene", "duskPlanes", "--seed", "7",
                                           "--autopilot", "--time",  "3",          "--size", "160x90"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = flight;
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  const ProcessResult first =
      runSkydrop(with({"--set", "cloudPlanes.count=2", "--set", "render.sun.elevationDegrees=4", "--set",
                       "quality=low", "--out", a}));
  ASSERT_EQ(first.exitCode, 0) << first.err;
  const ProcessResult info = runSkydrop({"info", a});
  ASSERT_EQ(info.exitCode, 0) << info.err;
  std::map<std::string, std::string> texts;
  std::istringstream lines(info.out);
  for (std::string line; std::getline(lines, line);)
    texts[line.substr(0, line.find(' '))] = line.substr(line.find(' ') + 1);
  EXPECT_EQ(texts.at("Scene"), "duskPlanes");
  EXPECT_EQ(texts.at("Seed"), "7");
  EXPECT_EQ(texts.at("Time"), "3 s");
  EXPECT_EQ(texts.at("Software").find("skydrop "), 0u);

  const std::filesystem::path preset = folder_.path() / "made.json";
  core::writeFileAtomically(preset, texts.at("Settings"));
  const ProcessResult again =
      runSkydrop(with({"--preset", preset.string(), texts.at("Pose"), "--set", "view.hud=true", "--out", b}));
  ASSERT_EQ(again.exitCode, 0) << again.err;
  EXPECT_EQ(runSkydrop({"compare", a, b, "--max", "0"}).exitCode, 0);

  const ProcessResult plain = runSkydrop({"info", picture("plain.png", 1, 2)});
  EXPECT_EQ(plain.exitCode, 1);
  EXPECT_NE(plain.err.find("plain.png: texts: the file says nothing about its picture"), std::string::npos)
      << plain.err;
}

TEST_F(ToolsProgram, statisticsAreWhatTheirSchemaSays) {
  if (!canCheckStatistics()) GTEST_SKIP() << "no python3 with jsonschema";
  const std::string stats = (folder_.path() / "stats.json").string();
  const std::string picture = (folder_.path() / "a.png").string();
  for (const std::vector<std::string>& run :
       {std::vector<std::string>{"simulate", "--seconds", "1"},
        {"render", "--scene", "fair", "--size", "64x36", "--out", picture},
        {"render", "--scene", "fair", "--size", "64x36", "--split", "clouds=low", "--out", picture}}) {
    std::vector<std::string> words = run;
    words.insert(words.end(), {"--stats", stats});
    const ProcessResult result = runSkydrop(words);
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(faultsOfStatistics(stats), "") << run[0];
  }
  auto json = nlohmann::json::parse(core::readTextFile(stats));
  json["gl"].erase("errors");
  json["unknown"] = 1;
  core::writeFileAtomically(stats, json.dump());
  EXPECT_NE(faultsOfStatistics(stats).find("'errors' is a required property"), std::string::npos);
  EXPECT_NE(faultsOfStatistics(stats).find("'unknown' was unexpected"), std::string::npos);
}

TEST_F(ToolsProgram, compareEndsWithOneBeyondALimit) {
  const std::string a = picture("a.png", 100, 100), b = picture("b.png", 100, 120);
  EXPECT_EQ(runSkydrop({"compare", a, b, "--max", "20", "--mean", "0.47", "--flip", "1"}).exitCode, 0);
  for (const auto& [flag, limit, reason] :
       {std::tuple("--max", "19", "the largest difference is 20, more than 19"),
        std::tuple("--mean", "0.46", "the mean difference is 0.4688, more than 0.46"),
        std::tuple("--flip", "0", "the mean FLIP is ")}) {
    const ProcessResult beyond = runSkydrop({"compare", a, b, flag, limit});
    EXPECT_EQ(beyond.exitCode, 1) << flag;
    EXPECT_EQ(beyond.err.find(std::string("skydrop: compare: ") + reason), 0u) << beyond.err;
  }
}

TEST_F(ToolsProgram, compareRefusesWhatCannotBeCompared) {
  const std::string a = picture("a.png", 100, 100), wide = picture("wide.png", 100, 100, 9);
  const std::string text = folder_.write("text.png", "no picture");
  const auto expect = [&](std::vector<std::string> words, int exitCode, const std::string& what) {
    words.insert(words.begin(), "compare");
    const ProcessResult result = runSkydrop(words);
    EXPECT_EQ(result.exitCode, exitCode) << what;
    EXPECT_NE(result.err.find(what), std::string::npos) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  };
  expect({a, wide}, 1, "is 8 x 4, not 9 x 4");
  expect({a, text}, 1, "text.png");
  expect({a, "missing.png"}, 1, "missing.png");
  expect({a}, 2, "2 required");
  expect({a, a, "--max", "256"}, 2, "--max");
  expect({a, a, "--mean", "-1"}, 2, "--mean");
  expect({a, a, "--flip", "nan"}, 2, "--flip");
}

TEST_F(ToolsProgram, settingsListsEverySetting) {
  // As many as there are, each with what setField() checks; the text has a line for each.
  const ProcessResult json = runSkydrop({"settings", "--json"}), text = runSkydrop({"settings"});
  ASSERT_EQ(json.exitCode, 0) << json.err;
  app::Settings settings;
  const core::SettingsTable table(settings);
  const auto list = nlohmann::json::parse(json.out).at("settings");
  ASSERT_EQ(list.size(), table.fields().size());
  EXPECT_EQ(std::count(text.out.begin(), text.out.end(), '\n'), std::ptrdiff_t(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i) {
    const core::Field& field = table.fields()[i];
    EXPECT_EQ(list[i].at("path"), field.path);
    EXPECT_EQ(list[i].at("help"), field.help);
    // What is shown as the default is what --set reads as the default.
    const auto& value = list[i].at("default");
    core::setField(field, value.is_string() ? value.get<std::string>() : value.dump());
    EXPECT_TRUE(field.isDefault()) << field.path << ' ' << value;
  }
}

TEST_F(ToolsProgram, settingsTakesAPathAndSuggestsTheNearest) {
  const ProcessResult group = runSkydrop({"settings", "wind"});
  EXPECT_EQ(group.exitCode, 0);
  EXPECT_NE(group.out.find("wind.speed\t"), std::string::npos) << group.out;
  EXPECT_EQ(group.out.find("aircraft."), std::string::npos);
  const ProcessResult former = runSkydrop({"settings", "clouds.scale"});  // its name before there were layers
  EXPECT_EQ(former.out.find("clouds.layers.0.scale\t"), 0u) << former.out;
  const ProcessResult unknown = runSkydrop({"settings", "wind.sped"});
  EXPECT_EQ(unknown.exitCode, 2);
  EXPECT_NE(unknown.err.find("'wind.speed'"), std::string::npos) << unknown.err;
}

}  // namespace
}  // namespace skydrop::test
