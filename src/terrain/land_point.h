// The land at one point, in double.
#pragma once

#include <glm/vec2.hpp>

#include "terrain/land_octaves.h"
#include "terrain/land_shape.h"

namespace skydrop::terrain {

// Height, metres, and its gradient. `shape` and `octaves` were made from `settings`.
Jet<double> landAt(const TerrainSettings& settings, const LandShape<double>& shape,
                   const LandOctaves& octaves, glm::dvec2 xz);

}  // namespace skydrop::terrain
