// The direction in which light comes through a cloud layer. Any thread.
#pragma once

#include <glm/vec3.hpp>

namespace skydrop::clouds {

// The sun's direction (unit), its elevation raised to a sine of at least kLeastSunSine
// (shaders/shared/cloud_light.glsl), so that the way through a layer stays finite. From straight below it is
// raised towards +x: any direction does for light that is not there.
glm::dvec3 raisedSun(const glm::dvec3& toSun);

}  // namespace skydrop::clouds
