// The report of a run, for people and for programs. Pure but for reading pictures and writing files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "skydrop/accuracy/result.h"

namespace skydrop::accuracy {

// Tables, one a case: errors, time, the front of the first metric. docs/accuracy.md is one.
std::string markdownReport(const Results& results);

// Schema 2: program, quick, studies[] {study, case, title, method, metrics[] {name, title, unit, floor},
// timed, timeUnit, clock, machine, points[] {label, set[], shipped[], errors[], ms {median, least, most,
// repeats[]}, onFront[], picture, heat}, references[] {label, changes[], picture}, doubts[], orders[],
// failure}. onFront has a flag a metric.
std::string jsonReport(const Results& results);

// RFC 4180, a line a point and metric.
std::string csvReport(const Results& results);

// One page that needs nothing else: styles, script, data and pictures are in it (assets/report). `folder`
// holds the pictures; embedded are those of points that are on a front or shipped, others are looked for
// beside the page.
std::string htmlReport(const Results& results, const std::filesystem::path& folder);

// accuracy.csv, .json, .md and .html in the folder. Returns the paths. Throws core::DataError.
std::vector<std::filesystem::path> writeReport(const Results& results, const std::filesystem::path& folder);

}  // namespace skydrop::accuracy
