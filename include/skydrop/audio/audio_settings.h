// Loudness, as factors of amplitude. Plain values; describe() states and enforces the ranges. AudioManager
// and SoundScene take a change over with the next update.
#pragma once

#include "skydrop/core/settings.h"

namespace skydrop::audio {

struct AudioSettings {
  double volume = 0.7;         // 0 .. 1, of everything
  double engineVolume = 0.6;   // 0 .. 1, of the engine, on top of `volume`
  double weatherVolume = 0.6;  // 0 .. 1, of rain and wind, on top of `volume`
  double natureVolume = 0.5;   // 0 .. 1, of birds and the sea, on top of `volume`
  bool mute = false;           // no sound at all; the device stays open
};

void describe(core::SettingsVisitor& visitor, AudioSettings& settings);

}  // namespace skydrop::audio
