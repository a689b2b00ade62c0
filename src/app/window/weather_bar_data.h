// What the weather bar shows of a flight, and what its requests mean for the settings.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/settings/settings.h"
#include "skydrop/core/settings_table.h"
#include "skydrop/ui/weather_bar.h"
#include "skydrop/weather/forecast.h"

namespace skydrop::app {

// Owns the texts and the strip, which is made once for a forecast. Main thread.
class WeatherBarData {
 public:
  // Of the camera's place x east, y up, z south, m. `status`: of the data, in words. Valid until the next
  // call; the forecast is kept.
  ui::WeatherBarContent content(const std::shared_ptr<const weather::Forecast>& forecast,
                                const Settings& settings, double seconds, const glm::dvec3& camera,
                                std::string status, bool isWrong);

  void showSite(std::size_t site) { site_ = site; }

 private:
  std::shared_ptr<const weather::Forecast> forecast_;  // of which the sites are
  std::vector<ui::StripSite> sites_;
  std::size_t site_ = 0;
  std::string clock_, place_, status_;
};

// The instant of the forecast at a simulated time.
double forecastMs(const Settings& settings, const weather::Forecast& forecast, double seconds);

// How fast that runs.
double forecastPace(const Settings& settings);

// Sets the rows of the clock that runs the forecast, that of the sky or its own, so that at this simulated
// time it shows the instant; or so that it runs at this speed from there on. Returns the rows that changed.
std::vector<std::string> moveForecast(const core::SettingsTable& table, const Settings& settings,
                                      const weather::Forecast& forecast, double seconds, double toMs);
std::vector<std::string> paceForecast(const core::SettingsTable& table, const Settings& settings,
                                      double seconds, double speed);

// "2026-06-21 14:30" and what else sky::readInstant() takes; nullopt for anything else.
std::optional<double> typedInstantMs(const std::string& text);

}  // namespace skydrop::app
