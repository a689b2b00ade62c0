// The weather bar: what it shows and asks for, and what its requests make of the settings.
#include "skydrop/ui/weather_bar.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>
#include <memory>

#include "app/session/flown_weather.h"
#include "app/window/overlay.h"
#include "app/window/weather_bar_data.h"
#include "skydrop/core/cpu_clock.h"
#include "support/instrumented.h"
#include "ui/interface_driver.h"

namespace skydrop::app {
namespace {

constexpr std::int64_t kFirst = 1782000000000, kHour = 3600000;  // ms: 2026-06-21T00:00Z

std::shared_ptr<const weather::Forecast> week() {
  std::vector<weather::TimedState> hours(169);
  for (std::size_t i = 0; i < hours.size(); ++i) {
    weather::State& state = hours[i].state;
    hours[i].utcMs = kFirst + static_cast<std::int64_t>(i) * kHour;
    state.wind.levels = {{{1500, 5, 0}, {5000, 5, 0}, {10000, 5, 0}}};
    state.layers[0] = {weather::Genus::cumulus, 1200, 2500,
                       0.5 + 0.5 * std::sin(0.3 * static_cast<double>(i)), 1};
    state.layers[1] = {weather::Genus::altocumulus, 3500, 4200, i % 48 < 20 ? 0.6 : 0.0, 1};
    state.layers[2] = {weather::Genus::cirrus, 9000, 10000, i % 30 < 20 ? 0.4 : 0.0, 1};
    state.precipitation.rain = i % 50 < 6 ? 2 : 0;
  }
  return std::make_shared<const weather::Forecast>(
      weather::Forecast{weather::Timeline(hours), weather::Timeline(hours), std::nullopt, 1});
}

// The bar over data that obey it, as the window has it.
struct Bar {
  Bar(int width, int height)
      : driver(width, height, [this](const ui::Interface& interface) { draw(interface); }) {}

  void draw(const ui::Interface& interface) {
    const ui::WeatherBarResult asked = bar.draw(
        interface, data.content(forecast, settings, seconds, {1200, 850, -300}, "Fetched 12 min ago", false));
    if (asked.live) settings.live.follow = *asked.live;
    if (asked.site) data.showSite(*asked.site);
    if (asked.speed) paceForecast(table, settings, seconds, *asked.speed);
    if (asked.moveToMs) moveForecast(table, settings, *forecast, seconds, *asked.moveToMs);
    if (asked.typed) {
      if (const auto typed = typedInstantMs(*asked.typed))
        moveForecast(table, settings, *forecast, seconds, *typed);
    }
  }
  double now() const { return forecastMs(settings, *forecast, seconds); }
  ui::ScreenRect place(const char* name) const { return bar.places().at(name); }

  std::shared_ptr<const weather::Forecast> forecast = week();
  Settings settings;
  core::SettingsTable table{settings};
  WeatherBarData data;
  ui::WeatherBar bar;
  double seconds = 100;
  test::InterfaceDriver driver;
};

TEST(WeatherBar, everythingIsInsideOfTheWindowFrom640x360To4K) {
  for (const auto& [width, height] : {std::pair(640, 360), std::pair(1280, 720), std::pair(3840, 2160)}) {
    const Bar bar(width, height);
    EXPECT_EQ(bar.bar.places().size(), 14u);
    float top = static_cast<float>(height), bottom = 0;
    for (const auto& [name, place] : bar.bar.places()) {
      EXPECT_GE(place.left, 0) << name << " " << width;
      EXPECT_LE(place.right, static_cast<float>(width)) << name << " " << width;
      top = std::min(top, place.top), bottom = std::max(bottom, place.bottom);
    }
    EXPECT_LE(bottom, static_cast<float>(height)) << width;
    EXPECT_GE(top, static_cast<float>(height) - ui::WeatherBar::height(bar.driver.context())) << width;
  }
}

TEST(WeatherBar, theMouseMovesTimeThroughTheHoursAndChoosesWhatIsFollowed) {
  Bar bar(640, 360);
  const ui::ScreenRect strip = bar.place("strip");
  const float y = (strip.top + strip.bottom) / 2;
  const auto dragTo = [&](float share) {
    bar.driver.button(strip.left + 10, y, true);
    bar.driver.move(strip.left + share * (strip.right - strip.left), y);
    bar.driver.frames(1);
    bar.driver.button(strip.left + share * (strip.right - strip.left), y, false);
    bar.driver.frames(1);
  };
  dragTo(0.5f);
  EXPECT_NEAR(bar.now(), kFirst + 84.0 * kHour, 0.3 * kHour) << "a pixel is a quarter of an hour";
  dragTo(1);
  EXPECT_NEAR(bar.now(), kFirst + 168.0 * kHour, 0.3 * kHour);
  const double before = bar.now();
  bar.driver.click(bar.place("-1 d"));
  EXPECT_NEAR(bar.now(), before - 24.0 * kHour, 1);
  bar.driver.click(bar.place("+1 h"));
  EXPECT_NEAR(bar.now(), before - 23.0 * kHour, 1);
  bar.driver.click(bar.place("play"));
  EXPECT_FALSE(bar.settings.live.follow);
  dragTo(0.2f);
  EXPECT_NEAR(bar.now(), before - 23.0 * kHour, 1) << "by hand there is no hour to choose";
  bar.driver.click(bar.place("live"));
  EXPECT_TRUE(bar.settings.live.follow);
  bar.driver.click(bar.place("site"));
  EXPECT_EQ(bar.data.content(bar.forecast, bar.settings, 0, {}, "", false).site, 1u);
}

TEST(WeatherBar, aTimeIsTyped) {
  Bar bar(1280, 720);
  bar.driver.click(bar.place("clock"));
  bar.driver.key(key::kLeftControl, true);
  bar.driver.tap('A');
  bar.driver.key(key::kLeftControl, false);
  bar.driver.frames(1);
  bar.driver.type("2026-06-23 06:30");
  bar.driver.tap(key::kEnter);
  EXPECT_NEAR(bar.now(), kFirst + 54.5 * kHour, 1);
  EXPECT_FALSE(typedInstantMs("half past six"));
  EXPECT_FALSE(typedInstantMs(""));
}

TEST(WeatherBar, anotherSpeedLeavesTheTimeWhereItIs) {
  // By the clock of the forecast; that of the sky is kept by ClockPace.
  Bar bar(1280, 720);
  const double before = bar.now();
  bar.driver.click(bar.place("speed 600"));
  EXPECT_EQ(bar.settings.weatherFile.pace, 600);
  EXPECT_NEAR(bar.now(), before, 1);
  bar.seconds += 10;
  EXPECT_NEAR(bar.now(), before + 6e6, 1);
  bar.driver.click(bar.place("speed 0"));
  bar.seconds += 50;
  EXPECT_NEAR(bar.now(), before + 6e6, 1);
}

TEST(WeatherBar, movesTheClockOfTheSkyWhereTheForecastFollowsThat) {
  Bar bar(1280, 720);
  bar.settings.render.sun.source = render::SunSource::clock;
  bar.settings.render.sun.utcMs = kFirst;
  bar.driver.frames(1);
  const double before = bar.now(), hour = bar.settings.weatherFile.hour;
  bar.driver.click(bar.place("+1 h"));
  EXPECT_NEAR(bar.now(), before + kHour, 1);
  EXPECT_EQ(bar.settings.render.sun.offsetSeconds, 3600);
  EXPECT_EQ(bar.settings.weatherFile.hour, hour);
  bar.driver.click(bar.place("speed 60"));
  EXPECT_EQ(bar.settings.render.sun.timeScale, 60);
}

TEST(WeatherBar, saysWhereTheCameraIsWhatTimeItIsAndThatAnHourIsHeld) {
  WeatherBarData data;
  Settings settings;
  settings.weatherFile.hour = 14.51;
  ui::WeatherBarContent content = data.content(week(), settings, 0, {1200, 850.4, -300}, "age", false);
  EXPECT_EQ(content.clock, "2026-06-21 14:30");
  EXPECT_EQ(content.place, "Camera 1.2 km east, 0.3 km north of the near site, 850 m");
  EXPECT_EQ(content.status, "age");
  settings.weatherFile.hour = 1e6;
  content = data.content(week(), settings, 0, {-1200, 0, 2300}, "age", false);
  EXPECT_EQ(content.place, "Camera 1.2 km west, 2.3 km south of the near site, 0 m");
  EXPECT_EQ(content.status, "After the last hour, which is held   age");
}

TEST(WeatherBar, hiddenItAddsNothingAndShownLessThanAThirdOfAMillisecond) {
  // CPU time of the content of a week and of the bar, mean of 600 frames, less that of frames without.
  constexpr Size kSize{1280, 720};
  Overlay overlay({}, kSize, {});
  overlay.hudShown = false;
  const auto forecast = week();
  Settings settings;
  const core::SettingsTable table(settings);
  const game::Snapshot snapshot;
  WeatherBarData data;
  const auto build = [&](bool shown) {
    OverlayFrame frame{snapshot, kSize, 1.0 / 60, table};
    std::optional<ui::WeatherBarContent> content;
    if (shown) content = data.content(forecast, settings, 0, {}, "", false);
    if (content) frame.weatherBar = &*content;
    overlay.build(frame);
    return ImGui::GetDrawData()->TotalVtxCount;
  };
  EXPECT_EQ(build(false), 0);
  build(true);
  EXPECT_GT(build(true), 4 * 168) << "an hour has a column or more";
  EXPECT_EQ(build(false), 0);
  const int frames = test::repetitions(600);
  const auto timed = [&](bool shown) {
    const core::CpuClock clock;
    for (int i = 0; i < frames; ++i) build(shown);
    return clock.ms() / frames;
  };
  timed(false);
  const double hidden = timed(false), shown = timed(true);
  RecordProperty("shownMs", std::to_string(shown - hidden));
  if (!test::kInstrumented) {
    EXPECT_LT(shown - hidden, 0.33);
  }
}

TEST(WeatherBar, tenThousandHoursAreDrawnAsNoMoreColumnsThanThereArePixels) {
  std::vector<weather::TimedState> hours(10000);
  for (std::size_t i = 0; i < hours.size(); ++i) {
    hours[i].utcMs = kFirst + static_cast<std::int64_t>(i) * kHour;
    hours[i].state.wind.levels = {{{1500, 5, 0}, {5000, 5, 0}, {10000, 5, 0}}};
    hours[i].state.layers[0] = {weather::Genus::cumulus, 1200, 2500, 0.5, 1};
  }
  Bar bar(640, 360);
  bar.driver.frames(1);
  const int few = bar.driver.drawData()->TotalVtxCount;
  bar.forecast = std::make_shared<const weather::Forecast>(
      weather::Forecast{weather::Timeline(hours), weather::Timeline(hours), std::nullopt, 1});
  bar.driver.frames(2);
  EXPECT_LT(bar.driver.drawData()->TotalVtxCount, few + 4 * 640 * 2);
}

}  // namespace
}  // namespace skydrop::app
