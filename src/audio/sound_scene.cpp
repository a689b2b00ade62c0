#include "skydrop/audio/sound_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "skydrop/core/assets.h"
#include "skydrop/weather/fall.h"

namespace skydrop::audio {
namespace {

using game::GameEventKind;

constexpr std::string_view kEngine = "engine", kStallHorn = "stall", kRain = "rain", kWind = "wind",
                           kWarning = "warning", kApplause = "applause";
constexpr std::array<std::string_view, 9> kEventSounds = {"drop",  "parachute", "landing",   "score",  "miss",
                                                          "crash", "splash",    "touchdown", kApplause};

constexpr std::array<std::string_view, 3> kThunder = {"thunderNear", "thunder", "thunderFar"};

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
    case GameEventKind::touchedDown:
      return "touchdown";
    case GameEventKind::ditched:
      return "splash";
    case GameEventKind::tookOff:
    case GameEventKind::packageRemoved:
    case GameEventKind::targetDrawn:
    case GameEventKind::respawned:
    case GameEventKind::reset:
      return std::nullopt;
  }
  return std::nullopt;
}

constexpr double kStalledPitch = 1.2, kWarningGain = 0.6;  // of the stall horn
// Of the air that streams past, heard above the engine from a little over the cruise on: m/s.
constexpr double kHeardFrom = 74, kLoudAt = 130, kLoudest = 0.7;
double airflowGain(double airspeed) {
  return kLoudest * std::clamp((airspeed - kHeardFrom) / (kLoudAt - kHeardFrom), 0.0, 1.0);
}

constexpr double kFaintest = 0.01;   // gain below which nobody hears a loop
constexpr double kCruiseSpeed = 70;  // m/s, where the airflow leaves the propeller's pitch alone

}  // namespace

SoundScene::SoundScene(AudioManager& audio, const AudioSettings& settings)
    : audio_(audio), settings_(settings) {
  audio_.load(soundFile(kEngine));
  audio_.load(soundFile(kStallHorn));
  audio_.load(soundFile(kWarning));
  for (const std::string_view name : kEventSounds) audio_.load(soundFile(name));
}

SoundScene::~SoundScene() {
  for (const Voice loop : {engine_, stallHorn_, warning_, rain_, wind_}) audio_.stop(loop);
}

void SoundScene::setLightning(const std::optional<weather::LightningSettings>& settings) {
  if (!settings) return thunder_.reset();
  for (const std::string_view name : kThunder) audio_.load(soundFile(name));
  if (thunder_)
    thunder_->apply(*settings);
  else
    thunder_.emplace(*settings);
}

double SoundScene::enginePitch(double throttle, double airspeed) {
  const double dive = std::clamp((airspeed - kCruiseSpeed) / kCruiseSpeed, -0.5, 1.0);
  return 0.7 + 0.6 * std::clamp(throttle, 0.0, 1.0) + 0.1 * dive;
}

double SoundScene::engineGain(double throttle) { return 0.45 + 0.55 * std::clamp(throttle, 0.0, 1.0); }

double SoundScene::rainGain(double rate, double airspeed) {
  const double impact = 0.35 + 0.65 * std::clamp(airspeed / kCruiseSpeed, 0.0, 1.5);
  return rate > 0 ? std::min(0.25 * std::sqrt(rate) * impact, 1.0) : 0;
}

double SoundScene::windGain(double meanMps, double gustMps) {
  return std::clamp(0.012 * std::max(meanMps, 0.0) + 0.06 * std::max(gustMps, 0.0), 0.0, 1.0);
}

std::optional<std::string> SoundScene::skipReason() const {
  if (audio_.isSilent()) return audio_.status();
  if (settings_.mute) return "muted";
  if (settings_.volume <= 0) return "the volume is 0";
  return std::nullopt;
}

void SoundScene::update(const game::Snapshot& now, std::span<const game::GameEvent> events) {
  if (skipReason()) {
    for (Voice* loop : {&engine_, &stallHorn_, &warning_, &rain_, &wind_})
      audio_.stop(std::exchange(*loop, 0));
    return;
  }
  if (thunder_) {
    for (const weather::Clap& clap : thunder_->due(now)) {
      const Voice voice = audio_.play2d(soundFile(kThunder[thunderSound(clap)]));
      audio_.setGain(voice, clap.gain);
    }
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
  if (!running || !now.pullUpSeconds) {
    audio_.stop(std::exchange(warning_, 0));
  } else if (warning_ == 0) {
    warning_ = audio_.play2d(soundFile(kWarning), true);
  }
  updateWeather(now);
  for (const game::GameEvent& event : events) {
    if (const auto sound = soundOf(event)) audio_.play2d(soundFile(*sound));
    if (event.kind == GameEventKind::scored) audio_.play2d(soundFile(kApplause));
  }
}

// A loop runs while it is heard at all; its file is read when it is heard first.
void SoundScene::updateWeather(const game::Snapshot& now) {
  double rain = 0, wind = 0, gust = 0;
  if (now.weather && now.aircraft.present && settings_.weatherVolume > 0) {
    const glm::dvec3& place = now.aircraft.position;
    const weather::Precipitation fall = weather::fallAt(now.weather.at({place.x, place.z}), place.y);
    const double airspeed = now.aircraft.crashed ? 0 : now.aircraft.airspeedMps;
    rain = rainGain(fall.rain + fall.sleet + 2 * fall.hail, airspeed);
    gust = now.air.present ? glm::length(now.air.velocity - now.air.wind) : 0;
    wind = windGain(glm::length(now.air.wind), gust);
  }
  const bool flies = now.aircraft.present && !now.aircraft.crashed;
  if (flies && settings_.weatherVolume > 0) wind = std::max(wind, airflowGain(now.aircraft.airspeedMps));
  const auto play = [&](Voice& voice, std::string_view name, double gain) {
    if (gain < kFaintest) {
      audio_.stop(std::exchange(voice, 0));
    } else if (voice == 0) {
      voice = audio_.play2d(soundFile(name), true);
    }
    audio_.setGain(voice, settings_.weatherVolume * gain);
  };
  play(rain_, kRain, rain);
  play(wind_, kWind, wind);
  audio_.setPitch(wind_, 0.9 + std::min(0.03 * gust, 0.4));
}

}  // namespace skydrop::audio
