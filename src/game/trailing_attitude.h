// An attitude that follows another one softly, as a chasing aircraft would. It lives in the simulation, at
// its fixed step, so a picture of it is a function of the drawn state whatever the frame rate. Decides
// nothing.
#pragma once

#include <glm/gtc/quaternion.hpp>

namespace skydrop::game {

class TrailingAttitude {
 public:
  void place(const glm::dquat& attitude) { attitude_ = attitude; }
  // One step of 1/120 s towards `attitude` (of unit length).
  void follow(const glm::dquat& attitude);

  const glm::dquat& orientation() const { return attitude_; }

 private:
  glm::dquat attitude_{1, 0, 0, 0};
};

}  // namespace skydrop::game
