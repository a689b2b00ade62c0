#include "skydrop/core/quantile.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace skydrop::core {

std::size_t quantileRank(std::size_t count, double quantile) {
  return static_cast<std::size_t>(std::max(std::ceil(quantile * static_cast<double>(count)) - 1, 0.0));
}

double quantileOf(std::span<const double> values, double quantile) {
  if (values.empty()) return 0;
  std::vector<double> sorted(values.begin(), values.end());
  const auto nth = sorted.begin() + static_cast<std::ptrdiff_t>(quantileRank(sorted.size(), quantile));
  std::nth_element(sorted.begin(), nth, sorted.end());
  return *nth;
}

}  // namespace skydrop::core
