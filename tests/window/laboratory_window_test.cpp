// The laboratory in its window and on the command line, as its user has it.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>

#include "skydrop/core/image.h"
#include "skydrop/lab/page.h"
#include "support/background_process.h"
#include "support/paths.h"
#include "support/process.h"
#include "support/temporary_folder.h"
#include "support/virtual_display.h"
#include "window/flown_game.h"

namespace skydrop::test {
namespace {

// False after a minute.
bool becomesTrue(const std::function<bool()>& condition) {
  for (int i = 0; i < 600; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return false;
}

TEST(LaboratoryWindow, showsAPageTurnsAndCloses) {
  // The picture comes up; dragging turns it; Escape ends the program with 0.
  if (!VirtualDisplay::missing().empty()) GTEST_SKIP() << VirtualDisplay::missing();
  const TemporaryFolder folder;
  const VirtualDisplay display(800, 600, (folder.path() / "server.log").string());
  BackgroundProcess program(
      {programFile(), "lab", "--page", "shapes", "--size", "800x600"},
      {"DISPLAY=" + display.name(), "XDG_CONFIG_HOME=" + folder.path().string(), "WAYLAND_DISPLAY"},
      (folder.path() / "lab.log").string());
  // A place of the sky that is no black background.
  ASSERT_TRUE(becomesTrue([&] { return display.picture().pixel(400, 60)[2] > 60; }));
  const core::Image before = display.picture();
  display.xdotool({"mousemove", "450", "150"});
  display.xdotool({"mousedown", "1"});
  display.xdotool({"mousemove", "500", "160"});
  EXPECT_TRUE(becomesTrue([&] {
    const core::Image now = display.picture();
    int changed = 0;
    for (int y = 100; y < 200; ++y) {
      for (int x = 300; x < 500; ++x) changed += now.pixel(x, y)[0] != before.pixel(x, y)[0];
    }
    return changed > 1000;
  }));
  display.xdotool({"mouseup", "1"});
  display.xdotool({"key", "Escape"});
  EXPECT_EQ(program.wait(60), 0);
}

TEST(LaboratoryWindow, theGamesMenuOpensItAndTheFlightIsThereAfterwards) {
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown;
  const auto isOn = [](const nlohmann::json& s, const char* what) { return s.at("window").at(what) == true; };
  flown.press("Escape");
  ASSERT_TRUE(flown.waitFor([&](const nlohmann::json& s) { return isOn(s, "escapeOpen"); }));
  flown.press("Down");
  flown.press("Down");
  const core::Image menu = flown.shown();
  flown.press("Return");
  // Another window covers the game: nearly every pixel changes.
  ASSERT_TRUE(flown.waitForPicture([&](const core::Image& now) {
    std::size_t changed = 0;
    for (std::size_t i = 0; i < now.rgba.size(); i += 4) changed += now.rgba[i] != menu.rgba[i];
    return changed > now.rgba.size() / 4 / 2;
  }));
  flown.press("Escape");
  flown.focus();
  flown.press("Up");
  flown.press("Up");
  flown.press("Return");
  EXPECT_TRUE(flown.waitFor([&](const nlohmann::json& s) { return !isOn(s, "escapeOpen"); })) << flown.log();
}

TEST(LaboratoryProgram, drawsAPageAndTellsItsFigures) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "page.png").string();
  for (const char* backend : {"egl", "osmesa"}) {
    const ProcessResult result = runSkydrop({"lab", "--page", "sphere-tracing", "--set", "stride=0.5",
                                             "--size", "160x90", "--backend", backend, "--out", file});
    if (result.exitCode == 3) continue;  // not to be had
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(core::readPng(file).width, 160);
    EXPECT_NE(result.out.find("steps a ray"), std::string::npos) << result.out;
  }
}

TEST(LaboratoryProgram, drawsAllPagesWithTheirGallery) {
  const TemporaryFolder folder;
  const std::filesystem::path out = folder.path() / "pages";
  const ProcessResult result = runSkydrop({"lab", "--all", "--size", "64x36", "--out", out.string()});
  if (result.exitCode == 3) GTEST_SKIP() << result.err;
  ASSERT_EQ(result.exitCode, 0) << result.err;
  for (const lab::Page& page : lab::pages())
    EXPECT_EQ(core::readPng(out / (std::string(page.name) + ".png")).height, 36) << page.name;
  EXPECT_TRUE(std::filesystem::exists(out / "gallery.md"));
}

TEST(LaboratoryProgram, refusesWhatItDoesNotKnowInOneLineWithTheNearestName) {
  const auto refusalOf = [](std::vector<std::string> words) {
    words.insert(words.begin(), "lab");
    const ProcessResult result = runSkydrop(words);
    EXPECT_EQ(result.exitCode, 2) << result.err;
    EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
    return result.err;
  };
  EXPECT_NE(refusalOf({"--page", "spere-tracing", "--out", "x.png"}).find("nearest are 'sphere-tracing'"),
            std::string::npos);
  EXPECT_NE(
      refusalOf({"--page", "halving", "--set", "strid=1", "--out", "x.png"}).find("nearest are 'stride'"),
      std::string::npos);
  EXPECT_NE(refusalOf({"--page", "halving", "--set", "stride=11", "--out", "x.png"})
                .find("stride: '11' is out of range 0 to 10"),
            std::string::npos);
  // The same without a picture: before any window.
  EXPECT_NE(refusalOf({"--page", "halvin"}).find("nearest are 'halving'"), std::string::npos);
  EXPECT_NE(refusalOf({"--page", "halving", "--set", "stride=x"}).find("stride"), std::string::npos);
  EXPECT_EQ(refusalOf({"--all"}), "skydrop: --all needs --out DIR\n");
  EXPECT_EQ(refusalOf({"--out", "x.png"}), "skydrop: --out needs --page NAME, or --all\n");
  EXPECT_EQ(refusalOf({"--page", "halving", "--out", "x.jpg"}),
            "skydrop: --out: 'x.jpg' does not end in .png\n");
  EXPECT_EQ(runSkydrop({"lab", "--list"}).exitCode, 0);
}

}  // namespace
}  // namespace skydrop::test
