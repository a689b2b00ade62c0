// The noise tool in its window, as its user has it.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <string>
#include <thread>

#include "skydrop/core/image.h"
#include "support/background_process.h"
#include "support/paths.h"
#include "support/process.h"
#include "support/temporary_folder.h"
#include "support/virtual_display.h"

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

// Whether a place shows noise: many greys.
bool showsNoise(const core::Image& picture) {
  int changes = 0;
  for (int x = 480; x < 760; ++x) changes += picture.pixel(x, 200)[0] != picture.pixel(x - 1, 200)[0];
  return changes > 100;
}

TEST(NoiseToolWindow, showsNoiseFollowsASliderAndCloses) {
  // The picture comes up; a click on a slider changes it; Escape ends the program with 0.
  if (!VirtualDisplay::missing().empty()) GTEST_SKIP() << VirtualDisplay::missing();
  const TemporaryFolder folder;
  const VirtualDisplay display(800, 600, (folder.path() / "server.log").string());
  BackgroundProcess tool(
      {programFile(), "noise", "--tool", "--size", "800x600"},
      {"DISPLAY=" + display.name(), "XDG_CONFIG_HOME=" + folder.path().string(), "WAYLAND_DISPLAY"},
      (folder.path() / "tool.log").string());
  ASSERT_TRUE(becomesTrue([&] { return showsNoise(display.picture()); }));
  const core::Image before = display.picture();
  // Near the left end of the row of octaves: one octave.
  display.xdotool({"mousemove", "125", "28"});
  display.xdotool({"mousedown", "1"});
  EXPECT_TRUE(becomesTrue([&] { return display.picture().rgba != before.rgba; }));
  display.xdotool({"mouseup", "1"});
  display.xdotool({"key", "Escape"});
  EXPECT_EQ(tool.wait(60), 0);
}

TEST(NoiseToolWindow, withoutADisplayItSaysSo) {
  const ProcessResult result = runSkydrop({"noise", "--tool"});
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
}

}  // namespace
}  // namespace skydrop::test
