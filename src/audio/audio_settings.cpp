#include "skydrop/audio/audio_settings.h"

namespace skydrop::audio {

void describe(core::SettingsVisitor& visitor, AudioSettings& settings) {
  const core::FieldNote muted =
      core::noteWhile([&settings] { return settings.mute; }, "Not heard while the sound is muted.");
  visitor.number("volume", settings.volume,
                 {.unit = "1",
                  .min = 0,
                  .max = 1,
                  .help = "Loudness of everything.",
                  .aliases = "loudness, master volume, gain",
                  .note = muted});
  visitor.number("engineVolume", settings.engineVolume,
                 {.unit = "1",
                  .min = 0,
                  .max = 1,
                  .help = "Loudness of the engine against the rest.",
                  .aliases = "motor, propeller, gain",
                  .note = muted});
  visitor.number("weatherVolume", settings.weatherVolume,
                 {.unit = "1",
                  .min = 0,
                  .max = 1,
                  .help = "Loudness of rain and wind against the rest, in flights with weather.",
                  .aliases = "storm, gusts, gain",
                  .note = muted});
  visitor.number("natureVolume", settings.natureVolume,
                 {.unit = "1",
                  .min = 0,
                  .max = 1,
                  .help = "Loudness of birds near woods and of the sea at its shores against the rest.",
                  .aliases = "birds, surf, waves, sea, gain",
                  .note = muted});
  visitor.flag("mute", settings.mute, {.help = "No sound at all.", .aliases = "silence, sound off"});
}

}  // namespace skydrop::audio
