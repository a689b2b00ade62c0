// How a road between two villages finds its way (terrain/places.h).
#pragma once

#include "skydrop/terrain/places.h"

namespace skydrop::terrain {

// Empty where the best way is too steep. bits: of its own.
Road planRoad(const HeightSource& ground, const Village& from, const Village& to, std::uint64_t bits);

}  // namespace skydrop::terrain
