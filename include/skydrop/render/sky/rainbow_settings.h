// Rain around the eye, by hand: what makes rainbows. A value; any thread.
#pragma once

#include "skydrop/core/settings.h"

namespace skydrop::render {

struct RainbowSettings {
  double extinction = 6e-4;   // 1/m, [0, 0.01]; Atlas (1953): 3.4e-4 R^0.63 for R mm/h
  double dropRadiusMm = 0.5;  // median of the drops, mm, [0.1, 1]
  double nearM = 500;         // where the rain begins, m from the eye, [0, 50000]
  double farM = 4000;         // where it ends, [0, 50000]; no rain unless more than nearM
  double topM = 1500;         // height above the sea up to which it fills the air, m, [0, 10000]

  bool operator==(const RainbowSettings&) const = default;
};

void describe(core::SettingsVisitor& visitor, RainbowSettings& settings);

}  // namespace skydrop::render
