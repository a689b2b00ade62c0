// Ice in the sky, by hand: what makes halos and sun dogs. A value; any thread.
#pragma once

#include "skydrop/core/settings.h"

namespace skydrop::render {

struct HaloSettings {
  double opticalDepth = 0.06;  // of regular crystals, of extinction, upright, [0, 3]
  double plates = 0.1;         // share of it in plates that lie level: sun dogs instead of halos, [0, 1]
  double heightM = 8000;       // above the sea, m, [500, 15000]

  bool operator==(const HaloSettings&) const = default;
};

void describe(core::SettingsVisitor& visitor, HaloSettings& settings);

}  // namespace skydrop::render
