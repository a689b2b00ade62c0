// The hard cases as tables: for a terminal, as docs/hard-cases.md, as a page, for programs. Pure.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "skydrop/stability/hard_case.h"
#include "skydrop/stability/live_check.h"

namespace skydrop::stability {

// A live check with what it gave here and now.
struct Measured {
  LiveCheck check;
  double figure = 0;
};
std::vector<Measured> measureAll();

// What was measured now, on `machine`, and by which program; then the recorded rows, by margin. Without `now`
// the rows alone.
struct HardCaseReport {
  HardCaseRecord record;
  std::vector<Measured> now;
  std::string program, machine;
};

std::string plainTable(const HardCaseReport& report);     // lines of a terminal
std::string markdownTable(const HardCaseReport& report);  // docs/hard-cases.md
std::string htmlTable(const HardCaseReport& report);      // a page that needs nothing else
std::string jsonTable(const HardCaseReport& report);  // {schema, now{program, machine, checks[]}, recorded}

}  // namespace skydrop::stability
