// What an aircraft rolls on at a place: the strip's turf, meadow, sand, scree, snow or water.
#pragma once

#include <glm/vec2.hpp>

#include "skydrop/flight/landing_gear.h"
#include "skydrop/terrain/height_source.h"

namespace skydrop::game {

// The ground below a point, bumps included; the sea is water at height 0. A pure function of the place.
// `roughness`: factor on the bumps.
flight::GroundPatch groundPatchAt(const terrain::HeightSource& ground, const glm::dvec2& xz,
                                  double roughness);

}  // namespace skydrop::game
