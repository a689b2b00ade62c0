// Conservative bounds of the land over a rectangle, without sampling it densely.
#pragma once

#include "skydrop/terrain/height_source.h"
#include "terrain/land_octaves.h"
#include "terrain/land_shape.h"

namespace skydrop::terrain {

// The rectangle is cut into kBoundsParts^2 parts. In each, an octave lies within its value and gradient at
// the middle and the bound of its curvature (Taylor), and within [-1, 1]; gullies within the height of the
// nodes around it. Interval arithmetic carries that through the shape. For a chunk: about 50 microseconds,
// and some 280 m too wide, most of it in mountains.
inline constexpr int kBoundsParts = 4;

HeightBounds landBounds(const LandShape<double>& shape, const LandOctaves& octaves, glm::dvec2 lo,
                        glm::dvec2 hi);

}  // namespace skydrop::terrain
