#include "skydrop/ui/hud.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace skydrop::ui {
namespace {

game::Snapshot flying() {
  game::Snapshot snapshot;
  snapshot.aircraft.present = true;
  snapshot.aircraft.position = {100, 812, -50};
  snapshot.aircraft.velocity = {60, 3, 0};
  snapshot.aircraft.airspeedMps = 60;
  snapshot.aircraft.headingRad = std::numbers::pi / 2;
  snapshot.aircraft.heightAboveGround = 310;
  snapshot.target.present = true;
  snapshot.target.position = {100, 40, -550};
  snapshot.target.distance = 500;
  return snapshot;
}

// Everything at once, with texts that are too long.
HudData fullest() {
  HudData data = makeHudData(flying());
  data.dropPulse = 1;
  data.cooldownSeconds = 1.5;
  data.stalled = data.paused = data.autopilot = true;
  data.score = data.misses = 123456789;
  data.targetDistanceM = 1e300;
  data.altitudeM = -1e12;
  const std::string longText =
      "The package landed in the water, 1234 m from the middle of the target, and is lost for ever. ";
  for (int i = 0; i < 3; ++i) data.messages.push_back({longText + longText, 1});
  return data;
}

std::vector<HelpRow> longHelp() {
  return std::vector<HelpRow>(16, {"Left, Right", "roll, and a sentence that does not fit into its column"});
}

bool overlap(const ScreenRect& a, const ScreenRect& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

constexpr int kSizes[][2] = {{320, 180},  {320, 240},   {640, 360},   {800, 601},   {1024, 768}, {1280, 720},
                             {720, 1280}, {1920, 1080}, {2560, 1080}, {3440, 1440}, {3840, 2160}};

TEST(Hud, noItemCoversAnotherOrLeavesTheWindowAtAnySize) {
  // Score, autopilot, instruments, messages, drop text, pause, warning and help keep apart, from 320 x 180
  // on.
  for (const auto& [width, height] : kSizes) {
    const Interface context(width, height);
    for (const bool help : {false, true}) {
      HudData data = fullest();
      const HudLayout layout = layoutHud(context, data, help ? longHelp() : std::vector<HelpRow>());
      ASSERT_GE(layout.items.size(), help ? 6u : 9u);
      for (std::size_t i = 0; i < layout.items.size(); ++i) {
        const HudItem& item = layout.items[i];
        SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height) + " " + item.name);
        EXPECT_LT(item.rect.left, item.rect.right);
        EXPECT_LT(item.rect.top, item.rect.bottom);
        EXPECT_GE(item.rect.left, 0);
        EXPECT_GE(item.rect.top, 0);
        EXPECT_LE(item.rect.right, static_cast<float>(width));
        EXPECT_LE(item.rect.bottom, static_cast<float>(height));
        for (std::size_t k = i + 1; k < layout.items.size(); ++k) {
          EXPECT_FALSE(overlap(item.rect, layout.items[k].rect)) << layout.items[k].name;
        }
      }
    }
  }
}

}  // namespace
}  // namespace skydrop::ui
