// Turns a row of the settings over all that its slider covers, a tenth at a time, and asks whether anything
// changes: a slider that does nothing over a part of its way is broken, or ends at the wrong place.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/core/settings_table.h"
#include "support/soak.h"

namespace skydrop::test {

// The ends of the slider's tenths (by ratios where it is logarithmic), all its powers of two, both values of
// a flag, each name of a choice. Whole numbers once each. Of tenths only four ends unless all are tried.
inline std::vector<double> rowSteps(const core::Field& field) {
  std::vector<double> steps;
  const double low = field.sliderMin, high = field.sliderMax;
  if (field.kind == core::FieldKind::flag || field.kind == core::FieldKind::choice) {
    for (double value = low; value <= high; ++value) steps.push_back(value);
  } else if (field.powersOfTwo) {
    for (double value = std::exp2(std::ceil(std::log2(low))); value <= high; value *= 2)
      steps.push_back(value);
  } else {
    for (int i = 0; i <= 10; ++i) {
      if (!triesAll() && i != 0 && i != 3 && i != 7 && i != 10) continue;
      double value = field.logarithmic ? low * std::pow(high / low, 0.1 * i) : low + (high - low) * 0.1 * i;
      if (i == 10) value = high;
      if (field.kind == core::FieldKind::integer) value = std::round(value);
      if (steps.empty() || steps.back() != value) steps.push_back(value);
    }
  }
  return steps;
}

// The ends of the slider and what is half way between them: for looks that take long.
inline std::vector<double> fewRowSteps(const core::Field& field) {
  const std::vector<double> all = rowSteps(field);
  if (all.size() <= 3) return all;
  return {all.front(), all[all.size() / 2], all.back()};
}

// A part of a slider that may do nothing where it is tried, and why: what a budget has room for once
// everything is there, or what the row's help or note says.
struct IdlePart {
  std::string_view path;
  double from, to;
  std::string_view reason;
};

// One line for each step between neighbours after which observe() gave the same digest. The field is as it
// was afterwards.
inline std::vector<std::string> idleSteps(const core::Field& field, std::span<const IdlePart> allowed,
                                          const std::function<std::uint64_t()>& observe,
                                          const std::vector<double>& steps) {
  const double kept = field.get();
  std::vector<std::string> idle;
  std::uint64_t before = 0;
  double from = 0;
  bool first = true;
  for (const double value : steps) {
    core::setField(field, value);
    const std::uint64_t now = observe();
    bool isAllowed = false;
    for (const IdlePart& part : allowed)
      isAllowed |= part.path == field.path && from >= part.from && value <= part.to;
    if (!first && now == before && !isAllowed) {
      field.set(from);
      const std::string text = core::fieldText(field);
      field.set(value);
      idle.push_back(field.path + ": nothing changes from " + text + " to " + core::fieldText(field));
    }
    before = now;
    from = value;
    first = false;
  }
  field.set(kept);
  return idle;
}
inline std::vector<std::string> idleSteps(const core::Field& field, std::span<const IdlePart> allowed,
                                          const std::function<std::uint64_t()>& observe) {
  return idleSteps(field, allowed, observe, rowSteps(field));
}

// Turns all rows of the groups through their steps, a failure for each idle one; the number of rows.
inline int expectNoIdleSteps(const core::SettingsTable& table, std::initializer_list<std::string_view> groups,
                             const std::function<std::uint64_t()>& observe) {
  int rows = 0;
  for (const core::Field& field : table.fields()) {
    const auto isOf = [&](std::string_view group) { return field.path.starts_with(group); };
    if (std::ranges::none_of(groups, isOf)) continue;
    ++rows;
    for (const std::string& line : idleSteps(field, {}, observe)) ADD_FAILURE() << line;
  }
  return rows;
}

}  // namespace skydrop::test
