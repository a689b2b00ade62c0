#include "app/window/weather_bar_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "app/session/flown_weather.h"
#include "skydrop/sky/instant.h"

namespace skydrop::app {
namespace {

// The heights that the World Meteorological Organization divides low, middle and high clouds by, m.
constexpr double kMiddleFromM = 2000, kHighFromM = 7000;

ui::StripHour hourOf(const weather::TimedState& timed) {
  ui::StripHour hour;
  hour.utcMs = static_cast<double>(timed.utcMs);
  std::array<double, 3> open{1, 1, 1};
  for (const weather::Layer& layer : timed.state.layers)
    open[layer.baseM >= kHighFromM ? 2 : layer.baseM >= kMiddleFromM ? 1 : 0] *= 1 - layer.cover;
  for (std::size_t i = 0; i < open.size(); ++i) hour.cover[i] = static_cast<float>(1 - open[i]);
  const weather::Precipitation& p = timed.state.precipitation;
  hour.rain = static_cast<float>(p.rain + p.snow + p.sleet + p.hail);
  return hour;
}

ui::StripSite siteOf(std::string name, const weather::Timeline& timeline) {
  ui::StripSite site{std::move(name), {}};
  for (const weather::TimedState& timed : timeline.states()) site.hours.push_back(hourOf(timed));
  return site;
}

bool followsSky(const Settings& settings) {
  return settings.weatherFile.followsSky && settings.render.sun.source == render::SunSource::clock;
}

std::string kilometres(double metres, const char* positive, const char* negative) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.1f km %s", std::abs(metres) / 1000,
                metres <= -50 ? negative : positive);
  return text.data();
}

void setWithin(const core::Field& field, double value) { field.set(std::clamp(value, field.min, field.max)); }

}  // namespace

double forecastMs(const Settings& settings, const weather::Forecast& forecast, double seconds) {
  return weather::utcMsAt(forecast, forecastClock(settings, forecast), seconds);
}

double forecastPace(const Settings& settings) {
  return followsSky(settings) ? settings.render.sun.timeScale : settings.weatherFile.pace;
}

ui::WeatherBarContent WeatherBarData::content(const std::shared_ptr<const weather::Forecast>& forecast,
                                              const Settings& settings, double seconds,
                                              const glm::dvec3& camera, std::string status, bool isWrong) {
  if (forecast_ != forecast) {
    forecast_ = forecast;
    sites_ = {siteOf("near site", forecast->near), siteOf("far site", forecast->far)};
  }
  ui::WeatherBarContent out;
  out.sites = sites_;
  out.site = std::min(site_, sites_.size() - 1);
  out.live = settings.live.follow;
  out.nowMs = forecastMs(settings, *forecast, seconds);
  out.speed = forecastPace(settings);
  const double minute =
      std::clamp(std::floor(out.nowMs / 60e3) * 60e3, static_cast<double>(sky::kFirstInstant.utcMs),
                 static_cast<double>(sky::kLastInstant.utcMs));
  clock_ = sky::instantText({static_cast<std::int64_t>(minute)}).substr(0, 16);
  std::replace(clock_.begin(), clock_.end(), 'T', ' ');
  out.clock = clock_;
  const weather::SiteSettings& near = settings.weather.sites[0];
  std::array<char, 32> height{};
  std::snprintf(height.data(), height.size(), ", %.0f m", camera.y);
  place_ = "Camera " + kilometres(camera.x - near.eastM, "east", "west") + ", " +
           kilometres(-camera.z - near.northM, "north", "south") + " of the near site" + height.data();
  out.place = place_;
  const weather::Held held = weather::heldAt(forecast->near, out.nowMs);
  if (held != weather::Held::within && out.live)
    status = std::string(held == weather::Held::before ? "Before the first" : "After the last") +
             " hour, which is held   " + status;
  status_ = std::move(status);
  out.status = status_;
  out.isWrong = isWrong;
  return out;
}

std::vector<std::string> moveForecast(const core::SettingsTable& table, const Settings& settings,
                                      const weather::Forecast& forecast, double seconds, double toMs) {
  const double deltaMs = std::round(toMs - forecastMs(settings, forecast, seconds));
  const std::string row = followsSky(settings) ? "render.sun.offsetSeconds" : "weatherFile.hour";
  const core::Field& field = table.at(row);
  setWithin(field, field.get() + deltaMs / (followsSky(settings) ? 1000 : 3.6e6));
  return {row};
}

std::vector<std::string> paceForecast(const core::SettingsTable& table, const Settings& settings,
                                      double seconds, double speed) {
  if (followsSky(settings)) {
    setWithin(table.at("render.sun.timeScale"), speed);
    return {"render.sun.timeScale"};
  }
  const double before = settings.weatherFile.pace;
  const core::Field& hour = table.at("weatherFile.hour");
  setWithin(table.at("weatherFile.pace"), speed);
  setWithin(hour, hour.get() + seconds * (before - settings.weatherFile.pace) / 3600);
  return {"weatherFile.hour", "weatherFile.pace"};
}

std::optional<double> typedInstantMs(const std::string& text) {
  sky::Instant instant;
  if (!sky::readInstant(text, instant).empty()) return std::nullopt;
  return static_cast<double>(instant.utcMs);
}

}  // namespace skydrop::app
