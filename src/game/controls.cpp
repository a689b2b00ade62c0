#include "skydrop/game/controls.h"

#include <algorithm>
#include <cmath>

#include "skydrop/core/guards.h"

namespace skydrop::game {
namespace {

constexpr double kSteps = 127;

std::int8_t toStep(double value, double lowest) {
  if (!std::isfinite(value)) {
    core::countGuard(core::Guard::notFiniteControl);
    return 0;
  }
  const double held = std::clamp(value, lowest, 1.0);
  return static_cast<std::int8_t>(std::copysign(std::floor(std::abs(held) * kSteps + 0.5), held));
}

}  // namespace

QuantisedControls quantise(const Controls& c) {
  return {toStep(c.thrust, 0),
          toStep(c.brake, 0),
          toStep(c.pitch, -1),
          toStep(c.roll, -1),
          toStep(c.yaw, -1),
          c.drop,
          c.reset};
}

Controls dequantise(const QuantisedControls& c) {
  return {c.thrust / kSteps, c.brake / kSteps, c.pitch / kSteps, c.roll / kSteps,
          c.yaw / kSteps,    c.drop,           c.reset};
}

Controls quantised(const Controls& controls) { return dequantise(quantise(controls)); }

}  // namespace skydrop::game
