#include "forecast/units.h"
#include "skydrop/forecast/report.h"
#include "skydrop/weather/state.h"

namespace skydrop::forecast {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

double between(const Report& report, std::size_t from, std::size_t to, std::size_t at, std::size_t quantity) {
  const double a = *report.hours[from].values[quantity], b = *report.hours[to].values[quantity];
  const double t = static_cast<double>(report.hours[at].utcMs - report.hours[from].utcMs) /
                   static_cast<double>(report.hours[to].utcMs - report.hours[from].utcMs);
  if (static_cast<Quantity>(quantity) == Quantity::windFromDeg) return weather::mixedDirection(a, 1, b, 1, t);
  return a + (b - a) * t;
}

// Fills what lies between the hours that have something, and before and after.
template <class Has, class Fill>
void fill(std::size_t count, const Has& has, const Fill& fill) {
  std::size_t before = kNone;
  for (std::size_t i = 0; i < count;) {
    if (has(i)) {
      before = i++;
      continue;
    }
    std::size_t after = i;
    while (after < count && !has(after)) ++after;
    if (before == kNone && after == count) return;  // no hour has it
    for (; i < after; ++i) fill(i, before, after == count ? kNone : after);
  }
}

// What an hour does without: kinds of precipitation while there is none, covers where layers were seen.
bool isNotAsked(const Hour& hour, Quantity quantity) {
  const bool isDry = hour[Quantity::precipitationMm] && *hour[Quantity::precipitationMm] == 0;
  if (quantity == Quantity::snowShare || quantity == Quantity::convectiveMm) return isDry;
  const bool isCover =
      quantity == Quantity::lowCover || quantity == Quantity::middleCover || quantity == Quantity::highCover;
  return isCover && hour.layers.has_value();
}

}  // namespace

std::vector<Missing> missingIn(const Report& report) {
  std::vector<Missing> out;
  for (std::size_t q = 0; q < kQuantities; ++q) {
    std::size_t missing = 0;
    const auto quantity = static_cast<Quantity>(q);
    for (const Hour& hour : report.hours) missing += hour.values[q] || isNotAsked(hour, quantity) ? 0 : 1;
    if (missing > 0) out.push_back({quantity, missing});
  }
  return out;
}

void fillGaps(Report& report) {
  std::vector<Hour>& hours = report.hours;
  for (std::size_t q = 0; q < kQuantities; ++q) {
    fill(
        hours.size(), [&](std::size_t i) { return hours[i].values[q].has_value(); },
        [&](std::size_t i, std::size_t before, std::size_t after) {
          if (before == kNone)
            hours[i].values[q] = hours[after].values[q];
          else if (after == kNone)
            hours[i].values[q] = hours[before].values[q];
          else
            hours[i].values[q] = between(report, before, after, i, q);
        });
  }
  const auto hold = [&](const auto& has, const auto& copy) {
    fill(hours.size(), has, [&](std::size_t i, std::size_t before, std::size_t after) {
      copy(hours[i], hours[before == kNone ? after : before]);
    });
  };
  hold([&](std::size_t i) { return hours[i].phenomena.has_value(); },
       [](Hour& to, const Hour& from) { to.phenomena = from.phenomena; });
  hold([&](std::size_t i) { return hours[i].layers.has_value(); },
       [](Hour& to, const Hour& from) { to.layers = from.layers; });
  hold([&](std::size_t i) { return !hours[i].aloft.empty(); },
       [](Hour& to, const Hour& from) { to.aloft = from.aloft; });
}

}  // namespace skydrop::forecast
