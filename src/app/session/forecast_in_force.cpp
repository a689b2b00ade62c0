#include "app/session/forecast_in_force.h"

namespace skydrop::app {

void ForecastInForce::set(const std::shared_ptr<const weather::Forecast>& forecast,
                          const weather::ForecastClock& clock, double seconds, double blendSeconds) {
  if (forecast != forecast_) {
    weather::Handover next{forecast_, clock_, seconds, blendSeconds};
    if (handover_ && handover_->from == forecast)
      next = weather::turnedBack(*handover_, forecast_, clock_, seconds);
    const bool blends = blendSeconds > 0;
    handover_ = blends ? std::make_shared<const weather::Handover>(next) : nullptr;
    forecast_ = forecast;
  }
  clock_ = clock;
}

bool ForecastInForce::endHandover(double seconds) {
  if (!handover_ || seconds < handover_->beginSeconds + handover_->lastsSeconds) return false;
  handover_.reset();
  return true;
}

}  // namespace skydrop::app
