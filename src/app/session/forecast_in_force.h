// Which weather is flown in: a forecast or the sites made by hand, and the handover from one to the other.
// Simulated time alone decides, so a replay of the same changes repeats it. Main thread.
#pragma once

#include <memory>

#include "skydrop/weather/handover.h"

namespace skydrop::app {

class ForecastInForce {
 public:
  // null: the sites of the settings.
  ForecastInForce(std::shared_ptr<const weather::Forecast> forecast, const weather::ForecastClock& clock)
      : forecast_(std::move(forecast)), clock_(clock) {}

  const std::shared_ptr<const weather::Forecast>& forecast() const { return forecast_; }
  const std::shared_ptr<const weather::Handover>& handover() const { return handover_; }

  // The weather to fly in from now on, with its clock; another than before takes over in `blendSeconds`, at
  // once where that is 0. While a handover goes on only the way back is as smooth.
  void set(const std::shared_ptr<const weather::Forecast>& forecast, const weather::ForecastClock& clock,
           double seconds, double blendSeconds);
  // True where a handover has just ended.
  bool endHandover(double seconds);

 private:
  std::shared_ptr<const weather::Forecast> forecast_;
  weather::ForecastClock clock_;
  std::shared_ptr<const weather::Handover> handover_;
};

}  // namespace skydrop::app
