#pragma once

#include <glm/vec3.hpp>

namespace skydrop::app {

// A camera in the world: metres; degrees; yaw 0 looks along +x (east) and grows towards +z (south), pitch up,
// roll right. A compass heading is yaw + 90.
struct Pose {
  glm::dvec3 position{0};
  double yawDegrees = 0, pitchDegrees = 0, rollDegrees = 0;
  bool aboveGround = false;  // position.y is counted from the surface, land or sea
};

}  // namespace skydrop::app
