// What is heard of a flight: the engine with the throttle, the horn that announces a stall, the warning of
// ground ahead, the game's events, applause for a hit, with weather rain and wind, and birds and the sea of
// the place. Built only for scenes that call for sound. Main thread.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "skydrop/audio/audio_manager.h"
#include "skydrop/audio/listener.h"
#include "skydrop/audio/surroundings.h"
#include "skydrop/audio/thunder_schedule.h"
#include "skydrop/game/events.h"
#include "skydrop/game/snapshot.h"

namespace skydrop::audio {

class SoundScene {
 public:
  // The manager must outlive it. Loads every sound: throws core::DataError for one that is broken.
  SoundScene(AudioManager& audio, const AudioSettings& settings);
  ~SoundScene();
  SoundScene(const SoundScene&) = delete;
  SoundScene& operator=(const SoundScene&) = delete;

  // Why nobody can hear anything; nullopt: it can be heard.
  std::optional<std::string> skipReason() const;
  // Once a frame, with the events of the steps since the last call. Where nobody can hear it nothing is
  // played. Who is not aboard hears the engine from where the aircraft was when its sound left; horn and
  // warning are heard aboard alone.
  void update(const game::Snapshot& now, std::span<const game::GameEvent> events,
              const Listener& listener = {}, const Surroundings& around = {});
  void apply(const AudioSettings& settings) { settings_ = settings; }
  // Thunder of these flashes from now on; nullopt: none is asked for, and nothing of it is loaded. Throws
  // core::DataError for a broken sound.
  void setLightning(const std::optional<weather::LightningSettings>& settings);

  // Pitch of the engine's loop at a throttle in [0, 1]: 0.7 idle .. 1.3 full, a little more in a dive. Speed
  // in m/s.
  static double enginePitch(double throttle, double airspeed);
  static double engineGain(double throttle);
  // Of rain on the canopy, [0, 1], at a rate of all that falls, mm/h, and an airspeed, m/s: the square root
  // of the power that drops bring, about; 0 when it is dry.
  static double rainGain(double rate, double airspeed);
  // Of the wind, [0, 1], in air that moves by so much more or less than its mean, m/s.
  static double windGain(double meanMps, double gustMps);

 private:
  void updateEngine(const game::Snapshot& now, const Listener& listener);
  void updateWarnings(const game::Snapshot& now, const Listener& listener);
  void updateWeather(const game::Snapshot& now, const Listener& listener);
  void updateNature(const Listener& listener, const Surroundings& around);
  // A loop runs while it is heard at all; its file is read when it is heard first.
  void play(Voice& loop, std::string_view name, double gain);

  AudioManager& audio_;
  AudioSettings settings_;
  Voice engine_ = 0, stallHorn_ = 0, warning_ = 0;
  Voice rain_ = 0, wind_ = 0;
  Voice birds_ = 0, water_ = 0;
  std::optional<ThunderSchedule> thunder_;
};

}  // namespace skydrop::audio
