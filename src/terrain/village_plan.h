// How a village is laid out (terrain/places.h).
#pragma once

#include <memory>

#include "skydrop/terrain/places.h"

namespace skydrop::terrain {

// Null: the cell has none.
std::shared_ptr<const Village> planVillage(const HeightSource& ground, const PlacesSettings& settings,
                                           std::int64_t cellX, std::int64_t cellZ);

}  // namespace skydrop::terrain
