// Where land from elevation data lies in the world, and how it ends.
#pragma once

#include "skydrop/core/settings.h"

namespace skydrop::elevation {

struct ElevationSettings {
  // The world's origin is the middle of the first file; else it is the place below.
  bool atCentre = true;
  double latitude = 46.9480;  // degrees north, [-90, 90]
  double longitude = 7.4474;  // degrees east, [-180, 180]: Bern
  double blendM = 4000;       // over which distance beyond the data it turns into the other land, m, [1, 1e5]

  bool operator==(const ElevationSettings&) const = default;
};

void describe(core::SettingsVisitor& visitor, ElevationSettings& settings);

}  // namespace skydrop::elevation
