#include "game/trailing_attitude.h"

#include <glm/geometric.hpp>

#include "skydrop/core/fixed_step.h"

namespace skydrop::game {
namespace {

// Time constants about pitch (x), yaw (y) and roll (z), s: what is left of a turn after them is 37 %. In a
// steady roll at full stick (2.5 rad/s) the picture hangs back by 35 degrees, in a full pull (.6 rad/s) by 6.
constexpr glm::dvec3 kSeconds{0.18, 0.2, 0.25};

}  // namespace

void TrailingAttitude::follow(const glm::dquat& attitude) {
  glm::dquat left = glm::conjugate(attitude_) * attitude;
  if (left.w < 0) left = -left;
  // For small angles half the rotation vector; for large ones it grows on, to 1 at half a turn.
  const glm::dvec3 part = glm::dvec3(left.x, left.y, left.z) * (core::FixedStep::kStepSeconds / kSeconds);
  attitude_ = glm::normalize(attitude_ * glm::dquat(1, part.x, part.y, part.z));
}

}  // namespace skydrop::game
