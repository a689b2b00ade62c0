#include "skydrop/audio/audio_settings.h"

namespace skydrop::audio {

void describe(core::SettingsVisitor& visitor, AudioSettings& settings) {
  visitor.number("volume", settings.volume, {"1", 0, 1, "Loudness of everything."});
  visitor.number("engineVolume", settings.engineVolume, {"1", 0, 1, "Loudness of the engine against the rest."});
  visitor.flag("mute", settings.mute, {"No sound at all."});
}

}  // namespace skydrop::audio
