#pragma once

#include "skydrop/core/settings.h"

namespace skydrop::render {

struct StarsSettings {
  double faintestMagnitude = 6;  // of those that are drawn, -1.5 .. 6; the eye sees 6 in a dark night
  double brightness = 1;         // times their own light, 0 .. 8
  double twinkle = 0.35;         // share by which stars low in the sky flicker, 0 .. 1
};

void describe(core::SettingsVisitor& visitor, StarsSettings& settings);

}  // namespace skydrop::render
