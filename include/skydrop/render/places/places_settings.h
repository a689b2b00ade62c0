// How villages are drawn; where they are is the land's (terrain/places.h). A value; any thread.
#pragma once

#include "skydrop/core/settings.h"

namespace skydrop::render {

struct PlacesViewSettings {
  double houseM = 2500;   // how far away buildings are drawn, m, [0, 3800]
  double hedgeM = 550;    // and hedges, m, [0, 2000]; beyond, they are painted on the land
  double windows = 0.55;  // share of the windows that are lit in the evening, [0, 1]
  double light = 1;       // how bright they are, [0, 5]

  bool operator==(const PlacesViewSettings&) const = default;
};

void describe(core::SettingsVisitor& visitor, PlacesViewSettings& settings);

}  // namespace skydrop::render
