// How grass, flowers, stones and reeds are drawn. A value; any thread.
#pragma once

#include "skydrop/core/settings.h"

namespace skydrop::render {

struct GroundCoverSettings {
  double reachM = 150;  // how far away anything of it stands, m, [0, 300]
  double density = 1;   // how much of it there is, [0, 3]; 0: nothing
  double sway = 1;      // how much plants give way to the wind, [0, 3]

  bool operator==(const GroundCoverSettings&) const = default;
};

void describe(core::SettingsVisitor& visitor, GroundCoverSettings& settings);

}  // namespace skydrop::render
