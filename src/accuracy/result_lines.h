// The lines of a results file as JSON, and what each adds to the results.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "skydrop/accuracy/result.h"

namespace skydrop::accuracy {

// Line endings included.
std::string headLine(const Results& results);
std::string caseLine(const CaseResult& result);  // what is known before anything is measured
std::string referenceLine(const CaseResult& of, std::size_t index);
std::string errorLine(const CaseResult& of, std::size_t point);
std::string timeLine(const CaseResult& of, std::size_t point, double ms);
std::string clockLine(const CaseResult& of);
std::string failureLine(const CaseResult& of);

// Adds what a line says. Throws core::DataError at `place`.
void addLine(const nlohmann::json& line, std::string_view file, std::string_view place, Results& results);

// Adds a case, or describes a known one again: what was measured of points and references that are still the
// same stays, a failure goes.
CaseResult& describeCase(const CaseResult& description, Results& results);

}  // namespace skydrop::accuracy
