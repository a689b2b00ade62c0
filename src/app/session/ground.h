// The land of a run.
#pragma once

#include <memory>

#include "app/session/simulation.h"

namespace skydrop::app {

// Sea at 0 without the effect terrain; with elevation data these, and procedural land around them; else
// procedural land. Throws core::DataError, core::RangeError.
std::shared_ptr<const terrain::HeightSource> makeGround(const scene::EffectSet& effects,
                                                        const Settings& settings,
                                                        const SimulationSetup& setup);

// Whether plants grow on it as high as on the earth: land of elevation data.
bool hasAlpineBelts(const terrain::HeightSource& ground);

}  // namespace skydrop::app
