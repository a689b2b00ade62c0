// Where settings stand between error and time, by what `skydrop accuracy` has measured. Pure functions but
// for the last.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "skydrop/accuracy/result.h"
#include "skydrop/core/settings_table.h"
#include "skydrop/ui/cost_panel.h"

namespace skydrop::app {

// One for each case whose points turn settings of the program (others turn what a study has of its own), and
// of each study the first such case. Errors are those of the case's first metric, by magnitude.
std::vector<ui::KnobStand> knobStands(const accuracy::Results& results, const core::SettingsTable& table);

// The folder whose results the panel shows: `accuracy` in the cache folder; empty without one.
std::filesystem::path measuredFrontsFolder();

struct MeasuredFronts {
  accuracy::Results results;
  std::string note;  // one line: what to do where there are none, or why they cannot be read; else empty
};
// Those of the folder. Does not throw.
MeasuredFronts readMeasuredFronts(const std::filesystem::path& folder);

}  // namespace skydrop::app
