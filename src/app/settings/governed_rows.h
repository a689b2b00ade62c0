// Rows that a frame budget has in force, over all that the player chose: for this run alone, never kept.
// Any thread.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "skydrop/accuracy/study.h"
#include "skydrop/core/settings_table.h"

namespace skydrop::app {

// Whether a budget may turn the row: only what is drawn, was studied, and takes effect at once or with a
// program that is compiled the first time (the tier ultra). Never what decides the simulation.
bool mayGovern(const core::Field& field);

// Rows and their values (core::Field::get) that a budget has in force.
using GovernedRows = std::vector<std::pair<std::string, double>>;

// All rows that the assignments set: a tier of the clouds brings those of its file along. Throws
// core::DataError that names `file`: for rows that a budget may not turn, and values out of range.
GovernedRows governedRows(const accuracy::Assignments& set, std::string_view file);

}  // namespace skydrop::app
