// The one meaning of "median" and "p99" in everything that the program measures.
#pragma once

#include <cstddef>
#include <span>

namespace skydrop::core {

// Index of a quantile in `count` sorted values, by nearest rank (Hyndman and Fan 1996, definition 1): the
// smallest value that at least the share `quantile` in [0, 1] of the values does not exceed. The median of an
// even number is the lower middle. count > 0.
std::size_t quantileRank(std::size_t count, double quantile);

// That value, of values in any order; 0 without values.
double quantileOf(std::span<const double> values, double quantile);

}  // namespace skydrop::core
