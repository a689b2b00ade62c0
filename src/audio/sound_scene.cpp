#include "skydrop/audio/sound_scene.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "skydrop/core/assets.h"

namespace skydrop::audio {
namespace {

using game::GameEventKind;

constexpr std::string_view kEngine = "engine", kStallHorn = "stall";
constexpr std::array<std::string_view, 7> kEventSounds = {"drop", "parachute", "landing", "score",
                                                          "miss", "crash",     "splash"};

std::filesystem::path soundFile(std::string_view name) {
  return core::assetPath("audio/" + std::string(name) + ".wav");
}

std::optional<std::string_view> soundOf(const game::GameEvent& event) {
  switch (event.kind) {
    case GameEventKind::drop:
      return "drop";
    case GameEventKind::parachuteOpened:
      return "parachute";
    case GameEventKind::packageLanded:
      return event.onWater ? "splash" : "landing";
    case GameEventKind::scored:
      return "score";
    case GameEventKind::missed:
      return "miss";
    case GameEventKind::crashed:
      return event.onWater ? "splash" : "crash";
    case GameEventKind::packageRemoved:
    case GameEventKind::targetDrawn:
    case GameEventKind::respawned:
    case GameEventKind::reset:
      return std::nullopt;
  }
  return std::nullopt;
}

constexpr double kStalledPitch = 1.2, kWarningGain = 0.6;  // of the stall horn
constexpr double kCruiseSpeed = 70;  // m/s, where the airflow leaves the propeller's pitch alone

}  // namespace

SoundScene::SoundScene(AudioManager& audio, const AudioSettings& settings)
    : audio_(audio), settings_(settings) {
  audio_.load(soundFile(kEngine));
  audio_.load(soundFile(kStallHorn));
  for (const std::string_view name : kEventSounds) audio_.load(soundFile(name));
}

SoundScene::~SoundScene() {
  audio_.stop(engine_);
  audio_.stop(stallHorn_);
}

double SoundScene::enginePitch(double throttle, double airspeed) {
  const double dive = std::clamp((airspeed - kCruiseSpeed) / kCruiseSpeed, -0.5, 1.0);
  return 0.7 + 0.6 * std::clamp(throttle, 0.0, 1.0) + 0.1 * dive;
}

double SoundScene::engineGain(double throttle) { return 0.45 + 0.55 * std::clamp(throttle, 0.0, 1.0); }

std::optional<std::string> SoundScene::skipReason() const {
  if (audio_.isSilent()) return audio_.status();
  if (settings_.mute) return "muted";
  if (settings_.volume <= 0) return "the volume is 0";
  return std::nullopt;
}

void SoundScene::update(const game::Snapshot& now, std::span<const game::GameEvent> events) {
  if (skipReason()) {
    for (Voice* loop : {&engine_, &stallHorn_}) audio_.stop(std::exchange(*loop, 0));
    return;
  }
  const bool running = now.aircraft.present && !now.aircraft.crashed;
  if (!running) {
    audio_.stop(engine_);
    engine_ = 0;
  } else if (engine_ == 0) {
    engine_ = audio_.play2d(soundFile(kEngine), true);
  }
  audio_.setPitch(engine_, enginePitch(now.aircraft.throttle, now.aircraft.airspeedMps));
  audio_.setGain(engine_, settings_.engineVolume * engineGain(now.aircraft.throttle));
  if (!running || !now.aircraft.stallWarning) {
    audio_.stop(stallHorn_);
    stallHorn_ = 0;
  } else if (stallHorn_ == 0) {
    stallHorn_ = audio_.play2d(soundFile(kStallHorn), true);
  }
  // Higher and louder in the stall than before it.
  audio_.setPitch(stallHorn_, now.aircraft.stalled ? kStalledPitch : 1);
  audio_.setGain(stallHorn_, now.aircraft.stalled ? 1 : kWarningGain);
  for (const game::GameEvent& event : events) {
    if (const auto sound = soundOf(event)) audio_.play2d(soundFile(*sound));
  }
}

}  // namespace skydrop::audio
