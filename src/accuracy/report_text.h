// Numbers and words that all forms of the report share.
#pragma once

#include <string>
#include <vector>

#include "skydrop/accuracy/result.h"

namespace skydrop::accuracy {

std::string shownNumber(double value);  // three digits
std::string exactNumber(double value);
// The error of a measured point, or its bound: "0.012", "\u2264 0.012".
std::string shownError(const CaseResult& result, std::size_t metric,
                       const PointResult& point);  // reads back to the same bits
std::string titled(const MetricColumn& metric);    // "distance, m"
// The lines of a case beneath its table: doubts, observed orders, failure. Plain text.
std::vector<std::string> remarksOf(const CaseResult& result);
bool isOnFront(const CaseResult& result, std::size_t metric, std::size_t point);

}  // namespace skydrop::accuracy
