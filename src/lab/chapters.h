// The chapters of the laboratory, and what their measurements share.
#pragma once

#include <cmath>
#include <numbers>
#include <utility>

#include "skydrop/lab/knobs.h"
#include "skydrop/lab/page.h"

namespace skydrop::lab {

std::vector<Page> marchPages();
std::vector<Page> distancePages();
std::vector<Page> noisePages();
std::vector<Page> cloudPages();

// Gives a page its knobs and what takes them.
template <class Settings>
Page withKnobs(Page page, const Settings& defaults, Figures (*measure)(const Settings&),
               std::vector<Curve> (*plot)(const Settings&) = nullptr) {
  page.makeKnobs = [defaults] { return std::make_unique<KnobsOf<Settings>>(defaults); };
  const auto settingsOf = [](const Knobs& knobs) -> const Settings& {
    return static_cast<const KnobsOf<Settings>&>(knobs).settings;
  };
  page.measure = [=](const Knobs& knobs) { return measure(settingsOf(knobs)); };
  if (plot) page.plot = [=](const Knobs& knobs) { return plot(settingsOf(knobs)); };
  return page;
}

// Where a value is in a plot whose axis goes from `low` to `high` by ratios; within [0, 1].
inline float logPlace(double value, double low, double high) {
  if (!(value > low)) return 0;
  return static_cast<float>(std::fmin(std::log(value / low) / std::log(high / low), 1.0));
}

inline double radians(double degrees) { return degrees * (std::numbers::pi / 180); }

}  // namespace skydrop::lab
