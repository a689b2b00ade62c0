#include "skydrop/forecast/renewal.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <utility>

#include "skydrop/forecast/forecast_of.h"

namespace skydrop::forecast {
namespace {

constexpr double kMinute = 60, kHour = 3600, kDay = 86400;  // s

}  // namespace

std::string ageText(sky::Instant fetched, sky::Instant now) {
  const double seconds = std::max(0.0, static_cast<double>(now.utcMs - fetched.utcMs) / 1000);
  std::array<char, 32> text{};
  if (seconds < kMinute)
    std::snprintf(text.data(), text.size(), "%.0f s", std::floor(seconds));
  else if (seconds < kHour)
    std::snprintf(text.data(), text.size(), "%.0f min", std::floor(seconds / kMinute));
  else if (seconds < 2 * kDay)
    std::snprintf(text.data(), text.size(), "%.1f h", seconds / kHour);
  else
    std::snprintf(text.data(), text.size(), "%.0f d", std::floor(seconds / kDay));
  return text.data();
}

sky::Instant machineNow() {
  using namespace std::chrono;
  return {duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count()};
}

Renewal::Renewal(RenewalSetup setup)
    : setup_(std::move(setup)), digest_(setup_.digest), periodSeconds_(setup_.periodSeconds) {
  state_.fetched = setup_.fetched;
  thread_ = std::jthread([this](std::stop_token stop) { work(stop); });
}

std::optional<Renewed> Renewal::take() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(renewed_, std::nullopt);
}

RenewalState Renewal::state() const {
  const std::scoped_lock lock(mutex_);
  return state_;
}

void Renewal::setPeriod(double seconds) {
  {
    const std::scoped_lock lock(mutex_);
    if (periodSeconds_ == seconds) return;
    periodSeconds_ = seconds;
  }
  wake_.notify_all();
}

// After a failure it is asked again by the back-off; else a period after the newest answer. A clock of the
// machine that was put back makes an answer one of the future: it counts as one of now.
double Renewal::dueInSeconds() const {
  if (failuresInARow_ > 0)
    return std::min(setup_.retrySeconds * std::pow(2.0, std::min(failuresInARow_ - 1, 20)), periodSeconds_);
  if (!state_.fetched) return 0;
  const double age = static_cast<double>(machineNow().utcMs - state_.fetched->utcMs) / 1000;
  return std::max(0.0, periodSeconds_ - std::max(0.0, age));
}

void Renewal::work(const std::stop_token& stop) {
  using Clock = std::chrono::steady_clock;
  while (!stop.stop_requested()) {
    {
      std::unique_lock lock(mutex_);
      const auto since = Clock::now();
      const double atStart = dueInSeconds();
      // Another period in the middle of the wait counts from its beginning.
      const double periodAtStart = periodSeconds_;
      wake_.wait_for(lock, stop, std::chrono::duration<double>(atStart),
                     [&] { return periodSeconds_ != periodAtStart; });
      const std::chrono::duration<double> waited = Clock::now() - since;
      if (stop.stop_requested()) return;
      if (waited.count() < atStart && dueInSeconds() > 0) continue;
    }
    ask(stop);
  }
}

void Renewal::ask(const std::stop_token& stop) {
  std::optional<KeptAnswer> kept;
  std::optional<Renewed> renewed;
  std::string failure;
  std::uint64_t digest = 0;
  {
    const std::scoped_lock lock(mutex_);
    ++state_.attempts;
    digest = digest_;
  }
  try {
    kept = renew(setup_.folder, setup_.request, machineNow(), setup_.limits, stop);
    FileForecast read = readForecast({kept->file}, setup_.farFiles, kept->fetched);
    if (read.nearDigests[0] != digest) {
      digest = read.nearDigests[0];
      renewed = Renewed{*read.forecast, std::move(read.notes)};
    }
  } catch (const std::exception& error) {
    failure = error.what();
  }
  if (stop.stop_requested()) return;
  const std::scoped_lock lock(mutex_);
  if (failure.empty()) {
    ++state_.answers;
    state_.fetched = kept->fetched;
    failuresInARow_ = 0;
    digest_ = digest;
    if (renewed) renewed_ = std::move(renewed);
  } else {
    ++failuresInARow_;
    if (state_.fetched)
      failure += "; the forecast that is flown in is " + ageText(*state_.fetched, machineNow()) + " old";
  }
  state_.failure = std::move(failure);
}

}  // namespace skydrop::forecast
