#include "skydrop/sky/rise_and_set.h"

#include <array>
#include <cmath>
#include <functional>

namespace skydrop::sky {
namespace {

constexpr double kSearchedDays = 2;
constexpr double kStepDays = 1.0 / 144;  // ten minutes: 2.5 degrees of rotation
constexpr int kSteps = static_cast<int>(kSearchedDays / kStepDays + 0.5);
constexpr double kHorizonRefraction = 34.0 / 60;
// A body that culminates this near to the horizon may cross it twice within two steps: in ten minutes from
// its highest place it sinks by at most 0.06 degrees.
constexpr double kGrazingDegrees = 0.1;

using Function = std::function<double(double)>;

// Where it grows through 0 between two times.
double crossing(const Function& value, double low, double high) {
  while (high - low > kEventToleranceDays) {
    const double middle = (low + high) / 2;
    (value(middle) <= 0 ? low : high) = middle;
  }
  return high;
}

// The place of the largest value between two times that lie about one.
double summit(const Function& value, double low, double high) {
  while (high - low > kEventToleranceDays) {
    const double third = (high - low) / 3;
    if (value(low + third) < value(high - third))
      low += third;
    else
      high -= third;
  }
  return (low + high) / 2;
}

using Samples = std::array<double, kSteps + 1>;

// The first time from `days` on at which sign * height, sampled at steps of kStepDays, grows through 0.
std::optional<double> firstRise(const Function& height, const Samples& samples, double sign, double days) {
  const Function value = [&](double time) { return sign * height(time); };
  const Function fall = [&](double time) { return -sign * height(time); };
  const auto at = [&](int i) { return sign * samples[static_cast<std::size_t>(i)]; };
  for (int i = 0; i < kSteps; ++i) {
    const double time = days + i * kStepDays;
    // Between the neighbours it may come through 0 and go back.
    if (i > 0 && std::abs(at(i)) < kGrazingDegrees && (at(i) <= 0) == (at(i - 1) <= 0) &&
        (at(i) <= 0) == (at(i + 1) <= 0)) {
      const double before = time - kStepDays, after = time + kStepDays;
      if (at(i) <= 0 && at(i) >= at(i - 1) && at(i) >= at(i + 1)) {
        const double top = summit(value, before, after);
        if (value(top) > 0) return crossing(value, before, top);
      } else if (at(i) > 0 && at(i) <= at(i - 1) && at(i) <= at(i + 1)) {
        const double bottom = summit(fall, before, after);
        if (value(bottom) <= 0) return crossing(value, bottom, after);
      }
    }
    if (at(i) <= 0 && at(i + 1) > 0) return crossing(value, time, time + kStepDays);
  }
  return std::nullopt;
}

Events eventsOf(Body (*bodyAt)(double, const Place&), double days, const Place& place) {
  const Function height = [&](double time) {
    const Body body = bodyAt(time, place);
    return body.horizontal.elevationDegrees + body.radiusDegrees + kHorizonRefraction;
  };
  const Function hourAngle = [&](double time) { return bodyAt(time, place).hourAngleDegrees; };
  Samples heights{}, angles{};
  for (std::size_t i = 0; i <= kSteps; ++i) {
    const double time = days + static_cast<double>(i) * kStepDays;
    heights[i] = height(time);
    angles[i] = hourAngle(time);
  }
  Events events;
  events.rise = firstRise(height, heights, 1, days);
  events.set = firstRise(height, heights, -1, days);
  if (!events.rise && !events.set)
    events.horizon = heights[0] > 0 ? Horizon::staysAbove : Horizon::staysBelow;
  for (std::size_t i = 0; i < kSteps && !events.transit; ++i) {
    const double time = days + static_cast<double>(i) * kStepDays;
    const bool isNear = angles[i] > -90 && angles[i + 1] < 90;
    if (isNear && angles[i] <= 0 && angles[i + 1] > 0)
      events.transit = crossing(hourAngle, time, time + kStepDays);
  }
  return events;
}

}  // namespace

Events sunEvents(double days, const Place& place) { return eventsOf(sunAt, days, place); }
Events moonEvents(double days, const Place& place) { return eventsOf(moonAt, days, place); }

}  // namespace skydrop::sky
