// What stands for light in clouds that scatters more than once, for the march in doubles. Any thread.
#pragma once

#include "skydrop/clouds/light_volume.h"
#include "skydrop/clouds/reference_march.h"

namespace skydrop::app {

// Steps, and samples towards the sun: a low sun's way is long, and 32 erred by .14 with it at 10 degrees, 128
// by less than .01.
clouds::MarchSteps stepsFor(double sunElevationDegrees);

// As LIGHT_VOLUME has it (shaders/clouds/volume_light.glsl). Both have to outlive it.
clouds::ScatteredLight litByVolume(const clouds::LightVolume& volume,
                                   const clouds::CloudLayerSettings& layer);

}  // namespace skydrop::app
