// The numerically hard cases (tests/stability/cases.json) with what the suite measured of them: the record
// that a build ships (assets/stability/hard_cases.json), and which tests/margins writes. Values; any thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/stability/limit.h"

namespace skydrop::stability {

inline constexpr int kHardCaseSchema = 1;
// A row that comes nearer to its limit says why.
inline constexpr double kWantedMargin = 2;

// Of all that the tests of a row measure, what has the least margin.
struct HeldFigure {
  double figure = 0;  // NaN where the record has none (null)
  Limit limit;
  std::string unit;
  std::string test;  // "Stability.T01_heightsFarOut"

  double margin() const { return marginOf(figure, limit); }
};

struct HardCase {
  std::string id;  // "T01"
  std::string area, input, mustHold;
  std::string reason;              // for a margin below kWantedMargin; or why a row has no test
  std::optional<HeldFigure> held;  // nothing: the game does not have what the row is about
  int figures = 0;                 // that its tests measure
};

struct HardCaseRecord {
  std::string program, machine, renderer, date;  // what measured it
  std::vector<HardCase> cases;                   // in the order of the list
};

// Throws core::DataError with file and place.
HardCaseRecord parseHardCases(std::string_view text, std::string_view file);
// Of the build's own data.
HardCaseRecord loadHardCases();
// As parseHardCases() reads it.
std::string hardCasesText(const HardCaseRecord& record);

// By margin, the least first; then what holds exactly; last what has no test. Equal ones keep their order.
std::vector<HardCase> sortedByMargin(std::vector<HardCase> cases);

}  // namespace skydrop::stability
