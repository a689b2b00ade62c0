// The weather of a service while flying: taken over when it comes, complained of once when it does not.
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

}  // namespace skydrop::app
