// What the tests of the configuration menu share.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "app/input/input_code.h"
#include "skydrop/ui/menu.h"
#include "ui/interface_driver.h"

namespace skydrop::ui {

// Settings as a program may have them: of every kind, live and slow, in groups.
enum class Quality { low, medium, high };
inline constexpr std::string_view kQualityNames[] = {"low", "medium", "high"};

struct Wing {
  double span = 10;
};

inline void describe(core::SettingsVisitor& visitor, Wing& wing) {
  visitor.number("span", wing.span, {"m", 1, 20, "From tip to tip."});
}

struct Aircraft {
  double rollFactor = 0.75;
  double mass = 1200;
  std::int64_t blades = 2;
  bool smoke = false;
  Quality quality = Quality::medium;
  Wing wing;
};

inline void describe(core::SettingsVisitor& visitor, Aircraft& a) {
  using core::TakesEffect;
  visitor.number(
      "rollFactor", a.rollFactor,
      {.unit = "1", .min = 0, .max = 2, .help = "How strongly the stick rolls.", .aliases = "AILERON"});
  visitor.number("mass", a.mass, {"kg", 1, 100000, "Of the aircraft.", TakesEffect::rebuild, true});
  visitor.integer("blades", a.blades, {"1", 1, 6, "Of the propeller."});
  visitor.flag("smoke", a.smoke, {"Leaves a trail."});
  visitor.choice("quality", a.quality, kQualityNames, {"Of the model."});
  visitor.group("wing", a.wing, "The wing.");
}

struct Weather {
  double scale = 0.595, cell = 64;
  std::int64_t seed = 7;
};

inline void describe(core::SettingsVisitor& visitor, Weather& w) {
  visitor.number(
      "scale", w.scale,
      {.unit = "%", .min = 0.001, .max = 4, .help = "Low: bigger, fluffier.", .slider = core::Range{0.5, 1}});
  visitor.number("cell", w.cell,
                 {.unit = "m",
                  .min = 4,
                  .max = 512,
                  .help = "Of the map.",
                  .takesEffect = core::TakesEffect::liveRebuild,
                  .logarithmic = true,
                  .powersOfTwo = true});
  visitor.integer("seed", w.seed, {"1", 0, 1e15, "Of the sky."});
}

struct Settings {
  Aircraft aircraft;
  Weather weather;
};

inline void describe(core::SettingsVisitor& visitor, Settings& s) {
  visitor.group("aircraft", s.aircraft, "The aircraft.");
  visitor.group("weather", s.weather, "The weather.");
}

// The menu over such a table in a window of 1280 x 720, and the hands that use it.
class MenuFixture : public testing::Test {
 protected:
  MenuFixture()
      : driver(1280, 720, [this](const Interface& context) {
          if (!shown) return;
          MenuContent content{table, sections, statistics, error};
          content.tools = {.frameMs = frameMs, .bases = bases, .pose = pose, .presets = presets};
          const MenuResult result = menu.draw(context, content);
          changed.insert(changed.end(), result.changedPaths.begin(), result.changedPaths.end());
          if (result.preset) request = result.preset;
          if (result.closed) shown = false;
        }) {}

  const MenuRowPlace& place(const std::string& path) const { return menu.places().at(path); }

  // Presses at `from` of the slider's width and moves to `to`, without releasing.
  void drag(const std::string& path, float from, float to) {
    const ScreenRect rect = place(path).value;
    const float y = (rect.top + rect.bottom) / 2, width = rect.right - rect.left;
    driver.move(rect.left + from * width, y);
    driver.button(rect.left + from * width, y, true);
    driver.move(rect.left + to * width, y);
  }
  void release(const std::string& path, float at) {
    const ScreenRect rect = place(path).value;
    driver.button(rect.left + at * (rect.right - rect.left), (rect.top + rect.bottom) / 2, false);
    driver.frames(1);
  }

  // Control and a click make a text field of a slider.
  void startTyping(const std::string& path) {
    driver.key(app::key::kLeftControl, true);
    driver.frames(1);
    driver.click(place(path).value);
    driver.key(app::key::kLeftControl, false);
    driver.frames(3);
  }
  void typeAndEnter(const char* text) {
    driver.type(text);
    driver.tap(app::key::kEnter);
  }
  void clickOn(std::string_view what) {
    ASSERT_NE(menu.place(what), nullptr) << what;
    driver.click(ScreenRect(*menu.place(what)));
  }
  void chord(int code, bool shift = false) {
    driver.key(app::key::kLeftControl, true);
    if (shift) driver.key(app::key::kLeftShift, true);
    driver.frames(1);
    driver.tap(code);
    driver.key(app::key::kLeftControl, false);
    if (shift) driver.key(app::key::kLeftShift, false);
    driver.frames(3);
  }
  void search(const char* text) {
    chord('F');
    driver.type(text);
    driver.frames(2);
  }
  std::vector<std::string> rows() const {
    std::vector<std::string> paths;
    for (const auto& [path, where] : menu.places()) paths.push_back(path);
    return paths;
  }

  Settings settings, base;
  core::SettingsTable table{settings}, baseTable{base};
  const core::SettingsTable* bases[1] = {&baseTable};
  std::vector<double> frameMs;
  std::string pose;
  std::vector<PresetEntry> presetList;
  std::optional<std::span<const PresetEntry>> presets;
  std::optional<PresetRequest> request;
  std::vector<MenuSection> sections = {{"aircraft", "Aircraft", true}};
  const core::FrameStatistics* statistics = nullptr;
  std::string error;
  bool shown = true;
  std::vector<std::string> changed;
  ConfigurationMenu menu;
  test::InterfaceDriver driver;  // last: its constructor draws
};

}  // namespace skydrop::ui
