// How the flashes of the weather are: a plain value; describe() states and enforces the ranges.
#pragma once

#include "skydrop/core/settings.h"

namespace skydrop::weather {

struct LightningSettings {
  double groundShare = 0.25;  // 0 .. 1, of the flashes that strike the ground
  double brightness = 1;      // 0 .. 4, times that of usual flashes
  double softness = 0;        // 0 .. 1: flashes that rise and fall more slowly, to a lower peak, and once

  bool operator==(const LightningSettings&) const = default;
};

void describe(core::SettingsVisitor& visitor, LightningSettings& settings);

}  // namespace skydrop::weather
