// How many villages the land has, and whether they are in the way (terrain/places.h). A value; any thread.
#pragma once

#include "skydrop/core/settings.h"

namespace skydrop::terrain {

struct PlacesSettings {
  double density = 0.8;   // share of the cells that may have a village, [0, 1]
  double fields = 0.85;   // share of the blocks around a village that are fields, [0, 1]
  bool obstacles = true;  // buildings stand in the way of the aircraft

  bool operator==(const PlacesSettings&) const = default;
};

void describe(core::SettingsVisitor& visitor, PlacesSettings& settings);

}  // namespace skydrop::terrain
