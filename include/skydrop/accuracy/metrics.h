// How far an observation is from the reference: the errors that studies show. Pure functions; any thread.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/accuracy/observation.h"

namespace skydrop::accuracy {

struct Metric {
  std::string_view name;   // as studies name it: "relativeRmse"
  std::string_view title;  // of its column: "relative RMSE"
  std::string_view unit;   // "1", "m"; empty: that of the observation's values
  std::string_view needs;  // what of the observation: "values", "picture", "positions" ...
  // >= 0 but for the bias, which has a sign; 0 where the two are equal. Both observations hold what it needs
  // and are of one shape (requireMeasurable).
  std::function<double(const Observation&, const Observation& reference)> measure;
};

// With mean(|r|) the mean magnitude of the reference's values, over all values:
//   bias           mean(a - r) / mean(|r|)            relativeRmse   sqrt(mean((a - r)^2)) / mean(|r|)
//   p99, largest   99th percentile and largest of |a - r| / mean(|r|)
//   rmse, worst    sqrt(mean((a - r)^2)) and largest |a - r|, in the unit of the values
//   flip           mean of the FLIP map (flip.h) of the pictures as they are seen, [0, 1]
//   metres         largest distance of positions
//   degrees        largest angle between attitudes
//   directionDegrees  root mean square angle between directions
//   relativeEnergy largest |a - r| / |r| of energies
// A mean magnitude of 0 counts as 1.
const std::vector<Metric>& metrics();
// Null when there is none of this name.
const Metric* findMetric(std::string_view name);
std::string unitOf(const Metric& metric, const Observation& observation);

// Throws core::RangeError, in one line, where the metric needs what the observations do not hold, or their
// shapes differ.
void requireMeasurable(const Metric& metric, const Observation& observation, const Observation& reference);

}  // namespace skydrop::accuracy
