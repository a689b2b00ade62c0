#include "app/input/key_axis_ramp.h"

#include <algorithm>
#include <cmath>

namespace skydrop::app {

double KeyAxisRamp::step(int side) {
  const int full = shape_.attackSteps * shape_.releaseSteps;
  if (side * place_ < 0 || side == 0) {
    const int back = std::min(shape_.attackSteps, std::abs(place_));
    place_ += place_ > 0 ? -back : back;
  } else {
    place_ = std::clamp(place_ + side * shape_.releaseSteps, -full, full);
  }
  const double x = static_cast<double>(std::abs(place_)) / full;
  return std::copysign(x * x * (3 - 2 * x), static_cast<double>(place_));
}

}  // namespace skydrop::app
