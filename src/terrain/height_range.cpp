#include "skydrop/terrain/height_range.h"

#include <cmath>
#include <string>

#include "skydrop/core/error.h"

namespace skydrop::terrain {

std::uint16_t HeightRange::encode(double height) const {
  const double code = std::floor((height - lowest) / step() + 0.5);
  if (!(code > 0)) return 0;
  return code < 65535 ? static_cast<std::uint16_t>(code) : 65535;
}

void HeightRange::requireValid() const {
  constexpr double kLargest = 1e6;  // m
  if (lowest >= -kLargest && highest <= kLargest && lowest < highest) return;
  throw core::RangeError("heights from " + std::to_string(lowest) + " to " + std::to_string(highest) +
                         " m cannot be stored: the range must rise and lie within 1e6 m");
}

}  // namespace skydrop::terrain
