// The bar at the bottom of the window for flights with weather data: live or play, the site, where the camera
// is, a slider over the hours of the forecast with the clouds' cover as a strip, and the speed of time. Reads
// plain data and returns what was asked for; what follows from that is the caller's business. Drawn between
// Interface::beginFrame and endFrame. Main thread.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/ui/imgui_context.h"

namespace skydrop::ui {

// What the strip shows of an hour.
struct StripHour {
  double utcMs = 0;              // since 1970
  std::array<float, 3> cover{};  // by low, middle and high clouds, [0, 1]
  float rain = 0;                // and snow, mm/h of water
};

struct StripSite {
  std::string name;              // "near site"
  std::vector<StripHour> hours;  // at least one, in the order of time
};

struct WeatherBarContent {
  std::span<const StripSite> sites;  // at least one
  std::size_t site = 0;              // whose hours are shown
  bool live = true;                  // the weather follows the data; else it is made by hand
  double nowMs = 0;                  // of the data's time, ms since 1970
  double speed = 1;                  // of that time, against simulated time
  std::string_view clock;            // the time as it is written: "2026-06-21 14:30"
  std::string_view place;            // of the camera, in words
  std::string_view status;           // of the data: its age, or what is wrong with it
  bool isWrong = false;              // the status is a complaint
};

struct WeatherBarResult {
  std::optional<double> moveToMs;    // the slider, or a step
  std::optional<std::string> typed;  // a time that was typed, as it stands
  std::optional<double> speed;
  std::optional<bool> live;
  std::optional<std::size_t> site;
};

// The speeds that have buttons.
inline constexpr std::array<double, 5> kBarSpeeds = {0, 1, 60, 600, 3600};

class WeatherBar {
 public:
  WeatherBarResult draw(const Interface& context, const WeatherBarContent& content);

  // What it takes of the window's height, pixels.
  static float height(const Interface& context);

  // Where the last frame drew its parts: "live", "play", "site", "clock", "strip", "-1 d", "-1 h", "+1 h",
  // "+1 d", "speed 60" (and the others).
  const std::map<std::string, ScreenRect, std::less<>>& places() const { return places_; }

 private:
  std::map<std::string, ScreenRect, std::less<>> places_;
  std::array<char, 32> typed_{};
  bool isTyping_ = false;
};

}  // namespace skydrop::ui
