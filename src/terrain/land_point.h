// The land at one point, in double.
#pragma once

#include <glm/vec2.hpp>

#include "terrain/land_gully.h"
#include "terrain/land_octaves.h"
#include "terrain/land_shape.h"

namespace skydrop::terrain {

// Height, metres, and its gradient. `shape` and `octaves` were made from the same settings. Each thread
// remembers nodes of gullies that it met, so neighbouring points cost a tenth of distant ones.
Jet<double> landAt(const LandShape<double>& shape, const LandOctaves& octaves, glm::dvec2 xz);

// Node (i, j) of gully octave `octave`.
GullyNode<double> gullyNodeAt(const LandShape<double>& shape, const LandOctaves& octaves, std::size_t octave,
                              std::int64_t i, std::int64_t j);

}  // namespace skydrop::terrain
