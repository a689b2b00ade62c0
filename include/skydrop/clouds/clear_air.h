// How far a place without cloud is from cloud, by its shape (cloudShapeEstimate() in
// shaders/shared/cloud_medium.glsl): what lets a march cross clear air in strides.
#pragma once

#include <cstddef>
#include <memory>

#include "skydrop/clouds/cloud_field.h"

namespace skydrop::clouds {

// From a place of shape f there is no cloud nearer than (leastShape - f) * slopeM, in nearly all cases: it is
// measured, not proven.
struct ClearAir {
  double leastShape = 0;  // below it detail leaves nothing of the shape, nearly everywhere
  double slopeM = 0;      // m for a unit of shape
};

// Of one of the settings' layers, below kCloudLayers (std::out_of_range). The same for the same arguments;
// any thread.
ClearAir measureClearAir(std::shared_ptr<const PackedCloudNoise> noise, const CloudSettings& settings,
                         std::size_t layer = 0);

}  // namespace skydrop::clouds
