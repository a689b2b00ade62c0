// Motion under gravity and a drag that is proportional to the velocity through the air: solved exactly, so a
// step of any length is stable and has no error but rounding.
#pragma once

#include <glm/vec3.hpp>

namespace skydrop::flight {

struct PointState {
  glm::dvec3 position{0};  // m
  glm::dvec3 velocity{0};  // m/s
};

// The state after `seconds` >= 0 of dv/dt = g - k (v - wind), k = `dragRate` >= 0 in 1/s, g = kGravity
// downwards. k = 0 is the parabola; the formulas join without cancellation.
PointState fallWithLinearDrag(const PointState& start, double dragRate, const glm::dvec3& wind,
                              double seconds);

}  // namespace skydrop::flight
