// The weather of a service while flying: taken over when it comes, complained of once when it does not.
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/console/message.h"
#include "app/window/fault_parts.h"
#include "app/window/window_game.h"

namespace skydrop::app {

void WindowGame::beginRenewal() {
  if (!run_->renewal) return;
  forecast::RenewalSetup setup = *run_->renewal;
  setup.periodSeconds = 60 * run_->settings.live.renewMinutes;
  renewal_ = std::make_unique<forecast::Renewal>(std::move(setup));
}

// Asks a mutex and moves what is ready: neither waits for the network.
void WindowGame::followRenewal() {
  if (!renewal_) return;
  renewal_->setPeriod(60 * run_->settings.live.renewMinutes);
  const forecast::RenewalState state = renewal_->state();
  if (state.failure.empty()) {
    faults_.clear(part::kWeather);
    saidRenewalFailed_ = false;
  } else {
    faults_.set(part::kWeather, state.failure);
    if (!std::exchange(saidRenewalFailed_, true)) warn(state.failure);
  }
  if (simulation_->isHandingOver()) return;  // the newest waits
  if (auto renewed = renewal_->take()) {
    for (const std::string& note : renewed->notes) warn(note);
    run_->setup.forecast = simulation_->takeForecast(renewed->forecast);
    notices_.add("A newer forecast has come");
  }
}

ui::WeatherBarContent WindowGame::weatherBarContent(const game::Snapshot& snapshot, Size size) {
  std::string status;
  bool isWrong = false;
  if (renewal_) {
    const forecast::RenewalState state = renewal_->state();
    isWrong = !state.failure.empty();
    status = isWrong || !state.fetched
                 ? state.failure
                 : "Fetched " + forecast::ageText(*state.fetched, forecast::machineNow()) + " ago";
  }
  return weatherBarData_.content(run_->setup.forecast, run_->settings, snapshot.simulatedSeconds,
                                 sceneRenderer_->view(snapshot, size).position, std::move(status), isWrong);
}

void WindowGame::serve(const ui::WeatherBarResult& asked) {
  if (!run_->setup.forecast) return;
  if (asked.live) followForecast(*asked.live);
  if (asked.site) weatherBarData_.showSite(*asked.site);
  if (asked.speed) paceForecastAt(*asked.speed);
  if (asked.moveToMs) moveForecastTo(*asked.moveToMs);
  if (!asked.typed) return;
  if (const auto typed = typedInstantMs(*asked.typed))
    moveForecastTo(*typed);
  else
    notices_.add("'" + *asked.typed + "' is no time: 2026-06-21 14:30");
}

void WindowGame::handleWeatherAction(Action action) {
  constexpr double kHourMs = 3.6e6;
  if (!run_->setup.forecast) return notices_.add("There is no weather data: --weather FILE, or --live");
  const core::WindowStatistics now = [this] {
    core::WindowStatistics window;
    writeWeatherTo(window);
    return window;
  }();
  const auto pace = [&](bool faster) {
    const auto& speeds = ui::kBarSpeeds;
    const auto above = std::ranges::upper_bound(speeds, now.forecastPace);
    const auto atLeast = std::ranges::lower_bound(speeds, now.forecastPace);
    if (faster && above != speeds.end()) paceForecastAt(*above);
    if (!faster && atLeast != speeds.begin()) paceForecastAt(*std::prev(atLeast));
  };
  switch (action) {
    case Action::weatherBar:
      return toggle("view.weatherBar");
    case Action::weatherMode:
      followForecast(!run_->settings.live.follow);
      return notices_.add(run_->settings.live.follow ? "The weather follows the data"
                                                     : "The weather is made by hand (F1, Weather)");
    case Action::hourBack:
      return moveForecastTo(static_cast<double>(now.forecastMs) - kHourMs);
    case Action::hourForward:
      return moveForecastTo(static_cast<double>(now.forecastMs) + kHourMs);
    case Action::timeSlower:
      return pace(false);
    default:
      return pace(true);
  }
}

// Times are of the frame that was seen last.
void WindowGame::moveForecastTo(double utcMs) {
  attempt(part::kChange, [&] {
    applyMenuChanges(SettingsChange(
        moveForecast(run_->table, run_->settings, *run_->setup.forecast, drawnSeconds_, utcMs)));
  });
}

void WindowGame::paceForecastAt(double speed) {
  attempt(part::kChange, [&] {
    applyMenuChanges(SettingsChange(paceForecast(run_->table, run_->settings, drawnSeconds_, speed)));
  });
}

void WindowGame::followForecast(bool live) {
  if (live != run_->settings.live.follow) toggle("live.follow");
}

void WindowGame::writeWeatherTo(core::WindowStatistics& window) const {
  window.weatherBar = showsWeatherBar();
  if (!run_->setup.forecast) return;
  const Settings& settings = run_->settings;
  window.weatherMode = settings.live.follow ? "live" : "play";
  window.forecastMs = std::llround(forecastMs(settings, *run_->setup.forecast, drawnSeconds_));
  window.forecastPace = forecastPace(settings);
}

}  // namespace skydrop::app
