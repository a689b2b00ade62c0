// Fog that lies on the ground: how dense and how high. A value; any thread.
#pragma once

#include "skydrop/core/settings.h"

namespace skydrop::render {

struct GroundFogSettings {
  double density = 0.008;    // extinction up to the base, 1/m, [0, 0.2]; 3.912 / visibility
  double baseM = 60;         // height above the sea above which the fog thins, m, [-500, 5000]
  double scaleHeightM = 40;  // height over which it thins to 37 %, m, [5, 2000]

  bool operator==(const GroundFogSettings&) const = default;
};

void describe(core::SettingsVisitor& visitor, GroundFogSettings& settings);

}  // namespace skydrop::render
