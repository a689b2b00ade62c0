// What a measured figure is held to, and how far it is from that.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

namespace skydrop::stability {

enum class Sense {
  below,
  atMost,
  above,
  atLeast,
  none  // a count of faults, and none may be: it has no margin
};

struct Limit {
  Sense sense = Sense::none;
  double value = 0;

  bool operator==(const Limit&) const = default;
};

constexpr Limit below(auto value) { return {Sense::below, static_cast<double>(value)}; }
constexpr Limit atMost(auto value) { return {Sense::atMost, static_cast<double>(value)}; }
constexpr Limit above(auto value) { return {Sense::above, static_cast<double>(value)}; }
constexpr Limit atLeast(auto value) { return {Sense::atLeast, static_cast<double>(value)}; }
inline constexpr Limit kNone{Sense::none, 0};

// NaN keeps to nothing.
constexpr bool keeps(double figure, const Limit& limit) {
  switch (limit.sense) {
    case Sense::below:
      return figure < limit.value;
    case Sense::atMost:
      return figure <= limit.value;
    case Sense::above:
      return figure > limit.value;
    case Sense::atLeast:
      return figure >= limit.value;
    case Sense::none:
      return figure == 0;
  }
  return false;
}

// The factor by which a figure may still grow: limit / figure where it may be no larger, figure / limit where
// it may be no smaller; less than 1 beyond the limit. Infinite where there is no such factor: a figure of 0
// that may be no larger, a limit of 0 that it may not be under, a count of none. NaN: -infinity.
inline double marginOf(double figure, const Limit& limit) {
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  if (std::isnan(figure)) return -kEndless;
  if (limit.sense == Sense::none) return figure == 0 ? kEndless : 0;
  if (limit.sense == Sense::above || limit.sense == Sense::atLeast)
    return limit.value > 0 ? figure / limit.value : kEndless;
  return figure > 0 ? limit.value / figure : kEndless;
}

// "<", "<=", ">", ">=", "="; and back, nothing for any other text.
constexpr std::string_view signOf(Sense sense) {
  constexpr std::string_view kSigns[] = {"<", "<=", ">", ">=", "="};
  return kSigns[static_cast<int>(sense)];
}
constexpr std::optional<Sense> senseOf(std::string_view sign) {
  for (const Sense sense : {Sense::below, Sense::atMost, Sense::above, Sense::atLeast, Sense::none}) {
    if (signOf(sense) == sign) return sense;
  }
  return std::nullopt;
}

}  // namespace skydrop::stability
