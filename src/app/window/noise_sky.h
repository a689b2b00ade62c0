// From the noise tool into the sky: a flight under clouds of the tool's noise.
#pragma once

#include "app/types/command_line.h"
#include "skydrop/noise/noise_recipe.h"

namespace skydrop::app {

// The flight that shows a texture as a cloud plane (scene `plane1`), or a volume as the cloud dome (scene
// `dome`). Window and player are those of the tool's command line. Values beyond what plane or dome can take
// are clamped; a recipe without a cut leaves the scene's.
CommandLine flightUnder(const noise::NoiseRecipe& recipe, bool isVolume, const CommandLine& tool);

}  // namespace skydrop::app
