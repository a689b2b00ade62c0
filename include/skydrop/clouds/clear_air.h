// What a march has to know of a field besides its textures: how far a place without cloud is from cloud, by
// its shape (cloudShapeEstimate() in shaders/shared/cloud_medium.glsl), which lets it cross clear air in
// strides; and how much detail wears edges in the mean, for places too far away for it to be seen.
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
  // Detail, [0, 1], that stands for all of it where it is not looked up: leaves the mean density as it is.
  double evenWear = 0.5;
};

// Of one of the settings' layers, below kCloudLayers (std::out_of_range). The same for the same arguments;
// any thread.
ClearAir measureClearAir(std::shared_ptr<const PackedCloudNoise> noise, const CloudSettings& settings,
                         std::size_t layer = 0);
ClearAir measureClearAir(std::shared_ptr<const PackedCloudNoise> noise, const LayerMedium& medium);

}  // namespace skydrop::clouds
