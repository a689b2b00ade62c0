// Moods as buttons and the clock of the sky, in the menu of all settings.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "app/session/effect_table.h"
#include "app/settings/settings.h"
#include "skydrop/sky/instant.h"
#include "skydrop/ui/menu.h"
#include "ui/interface_driver.h"

namespace skydrop::ui {
namespace {

class SkySectionTest : public testing::Test {
 protected:
  SkySectionTest()
      : driver(1280, 720, [this](const Interface& context) {
          MenuContent content{table, sections};
          content.tools.clockMs = static_cast<double>(settings.render.sun.utcMs) + elapsedMs;
          const MenuResult result = menu.draw(context, content);
          changed.insert(result.changedPaths.begin(), result.changedPaths.end());
        }) {
    MenuState state;
    state.open["sky"] = state.open["render.sun"] = true;
    menu.setState(state);
    driver.frames(2);
  }

  void clickOn(const std::string& what) {
    ASSERT_NE(menu.place(what), nullptr) << what;
    changed.clear();
    driver.click(ScreenRect(*menu.place(what)));
    driver.frames(2);
  }
  std::string utc() const { return sky::instantText({settings.render.sun.utcMs}); }

  app::Settings settings;
  core::SettingsTable table{settings};
  std::vector<MenuSection> sections = [] {
    std::vector<MenuSection> ofSky;
    scene::EffectSet effects;
    effects.insert(scene::Effect::sky);
    for (MenuSection& section : app::menuSections(effects)) {
      if (section.head != MenuSection::Head::none) ofSky.push_back(std::move(section));
    }
    return ofSky;
  }();
  double elapsedMs = 0;
  std::set<std::string> changed;
  ConfigurationMenu menu;
  test::InterfaceDriver driver;  // last: its constructor draws
};

TEST_F(SkySectionTest, aClickPicksAMoodAndAnotherClickOnItNone) {
  // A button for each of the eight, within the menu and apart from each other.
  std::vector<ScreenRect> places;
  for (std::size_t i = 1; i < app::kMoodNames.size(); ++i) {
    const ScreenRect* place = menu.place("mood " + std::string(app::kMoodNames[i]));
    ASSERT_NE(place, nullptr) << app::kMoodNames[i];
    EXPECT_LE(place->right, menu.place().right);
    for (const ScreenRect& other : places) {
      EXPECT_TRUE(place->left >= other.right || place->top >= other.bottom || place->right <= other.left ||
                  place->bottom <= other.top)
          << app::kMoodNames[i];
    }
    places.push_back(*place);
  }
  EXPECT_EQ(places.size(), 8u);
  clickOn("mood goldenSunset");
  EXPECT_EQ(settings.sky.mood, app::Mood::goldenSunset);
  EXPECT_TRUE(changed.contains("sky.mood"));
  clickOn("mood dusk");
  EXPECT_EQ(settings.sky.mood, app::Mood::dusk);
  clickOn("mood dusk");
  EXPECT_EQ(settings.sky.mood, app::Mood::none);
}

TEST_F(SkySectionTest, stepsTurnTheClockAndSpeedsRunIt) {
  // Each step moves the date that the flight began at, so that the clock shows another time at any moment of
  // the flight; it takes the sun from hand.
  elapsedMs = 5000;
  EXPECT_EQ(settings.render.sun.source, render::SunSource::manual);
  clickOn("clock +1 h");
  EXPECT_EQ(settings.render.sun.source, render::SunSource::clock);
  EXPECT_EQ(utc(), "2026-06-21T11:00:00Z");
  clickOn("clock -10 min");
  EXPECT_EQ(utc(), "2026-06-21T10:50:00Z");
  clickOn("clock +1 d");
  EXPECT_EQ(utc(), "2026-06-22T10:50:00Z");
  clickOn("speed 600");
  EXPECT_EQ(settings.render.sun.timeScale, 600);
  EXPECT_EQ(utc(), "2026-06-22T10:50:00Z");
  clickOn("speed 0");
  EXPECT_EQ(settings.render.sun.timeScale, 0);
}

TEST_F(SkySectionTest, theSliderGoesThroughTheDayOfTheClock) {
  // A drag from the middle to a quarter: 6 in the morning of the same day, within the slider's pixels.
  const ScreenRect rect = *menu.place("clock");
  const float y = (rect.top + rect.bottom) / 2, width = rect.right - rect.left;
  driver.move(rect.left + 0.5f * width, y);
  driver.button(rect.left + 0.5f * width, y, true);
  driver.move(rect.left + 0.25f * width, y);
  driver.frames(2);
  driver.button(rect.left + 0.25f * width, y, false);
  driver.frames(2);
  const std::int64_t six = sky::parseInstant("2026-06-21T06:00:00Z").utcMs;
  EXPECT_NEAR(static_cast<double>(settings.render.sun.utcMs - six) / 60e3, 0, 20) << utc();
  EXPECT_TRUE(changed.contains("render.sun.utc"));
}

}  // namespace
}  // namespace skydrop::ui
