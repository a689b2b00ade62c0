#pragma once

#include "skydrop/core/settings.h"

namespace skydrop::audio {

struct AudioSettings {
  double volume = 0.7;
  double engineVolume = 0.6;
  bool mute = false;
};

void describe(core::SettingsVisitor& visitor, AudioSettings& settings);

}  // namespace skydrop::audio
