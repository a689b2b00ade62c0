// Optical depth of a cloud layer between a place and the sun, on the processor: for what is small against
// clouds and lit as a whole (aircraft, packages).
#pragma once

#include <glm/vec3.hpp>

#include "skydrop/clouds/cloud_field.h"

namespace skydrop::clouds {

inline constexpr int kSunDepthSamples = 192;

// `place` in m as CloudField::density() takes it, anywhere; toSun: unit vector, as raisedSun() gives it. At
// least 0; 0 above the layer. So many samples of 32 bits, at least 1, closer together near the place: 192
// take 13 to 28 us (study clouds-shade).
double sunOpticalDepth(const CloudField& field, const glm::dvec3& place, const glm::dvec3& toSun,
                       int samples = kSunDepthSamples);

}  // namespace skydrop::clouds
