// Optical depth of a cloud layer between a place and the sun, on the processor: for what is small against
// clouds and lit as a whole (aircraft, packages).
#pragma once

#include <glm/vec3.hpp>

#include "skydrop/clouds/cloud_field.h"

namespace skydrop::clouds {

// `place` in m as CloudField::density() takes it, anywhere; toSun: unit vector, as raisedSun() gives it. At
// least 0; 0 above the layer. 48 samples of 32 bits, closer together near the place: 4 us.
double sunOpticalDepth(const CloudField& field, const glm::dvec3& place, const glm::dvec3& toSun);

}  // namespace skydrop::clouds
