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
                           kWarning = "warning", kApplause = "applause", kBirds = "birds", kWater = "water";
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

constexpr double kThroughCabin = 0.4;  // of the place's sounds
constexpr double kFaintest = 0.01;     // gain below which nobody hears a loop
constexpr double kCruiseSpeed = 70;    // m/s, where the airflow leaves the propeller's pitch alone

}  // namespace

SoundScene::SoundScene(AudioManager& audio, const AudioSettings& settings)
    : audio_(audio), settings_(settings) {
  audio_.load(soundFile(kEngine));
  audio_.load(soundFile(kStallHorn));
  audio_.load(soundFile(kWarning));
  for (const std::string_view name : kEventSounds) audio_.load(soundFile(name));
}

SoundScene::~SoundScene() {
  for (const Voice loop : {engine_, stallHorn_, warning_, rain_, wind_, birds_, water_}) audio_.stop(loop);
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

void SoundScene::update(const game::Snapshot& now, std::span<const game::GameEvent> events,
                        const Listener& listener, const Surroundings& around) {
  if (skipReason()) {
    for (Voice* loop : {&engine_, &stallHorn_, &warning_, &rain_, &wind_, &birds_, &water_})
      audio_.stop(std::exchange(*loop, 0));
    return;
  }
  if (thunder_) {
    for (const weather::Clap& clap : thunder_->due(now)) {
      const Voice voice = audio_.play2d(soundFile(kThunder[thunderSound(clap)]));
      audio_.setGain(voice, clap.gain);
    }
  }
  updateEngine(now, listener);
  updateWarnings(now, listener);
  updateWeather(now, listener);
  updateNature(listener, around);
  for (const game::GameEvent& event : events) {
    if (const auto sound = soundOf(event)) audio_.play2d(soundFile(*sound));
    if (event.kind == GameEventKind::scored) audio_.play2d(soundFile(kApplause));
  }
}

void SoundScene::play(Voice& loop, std::string_view name, double gain) {
  if (gain < kFaintest) {
    audio_.stop(std::exchange(loop, 0));
  } else if (loop == 0) {
    loop = audio_.play2d(soundFile(name), true);
  }
  audio_.setGain(loop, gain);
}

void SoundScene::updateEngine(const game::Snapshot& now, const Listener& listener) {
  const game::AircraftSnapshot& aircraft = now.aircraft;
  Arrival arrival;
  if (!listener.aboard) arrival = arrivalFrom(aircraft.position, aircraft.velocity, listener);
  const bool runs = aircraft.present && !aircraft.crashed;
  play(engine_, kEngine, runs ? settings_.engineVolume * engineGain(aircraft.throttle) * arrival.gain : 0);
  audio_.setPitch(engine_, enginePitch(aircraft.throttle, aircraft.airspeedMps) * arrival.pitch);
  audio_.setPan(engine_, arrival.pan);
}

void SoundScene::updateWarnings(const game::Snapshot& now, const Listener& listener) {
  const bool heard = listener.aboard && now.aircraft.present && !now.aircraft.crashed;
  // Higher and louder in the stall than before it.
  play(stallHorn_, kStallHorn,
       !heard || !now.aircraft.stallWarning ? 0
       : now.aircraft.stalled               ? 1
                                            : kWarningGain);
  audio_.setPitch(stallHorn_, now.aircraft.stalled ? kStalledPitch : 1);
  play(warning_, kWarning, heard && now.pullUpSeconds ? 1 : 0);
}

void SoundScene::updateWeather(const game::Snapshot& now, const Listener& listener) {
  double rain = 0, wind = 0, gust = 0;
  if (now.weather && now.aircraft.present && settings_.weatherVolume > 0) {
    const glm::dvec3& place = listener.aboard ? now.aircraft.position : listener.position;
    const weather::Precipitation fall = weather::fallAt(now.weather.at({place.x, place.z}), place.y);
    const double airspeed = now.aircraft.crashed || !listener.aboard ? 0 : now.aircraft.airspeedMps;
    rain = rainGain(fall.rain + fall.sleet + 2 * fall.hail, airspeed);
    gust = now.air.present ? glm::length(now.air.velocity - now.air.wind) : 0;
    wind = windGain(glm::length(now.air.wind), gust);
  }
  const bool flies = listener.aboard && now.aircraft.present && !now.aircraft.crashed;
  if (flies && settings_.weatherVolume > 0) wind = std::max(wind, airflowGain(now.aircraft.airspeedMps));
  play(rain_, kRain, settings_.weatherVolume * rain);
  play(wind_, kWind, settings_.weatherVolume * wind);
  audio_.setPitch(wind_, 0.9 + std::min(0.03 * gust, 0.4));
}

void SoundScene::updateNature(const Listener& listener, const Surroundings& around) {
  const double share = settings_.natureVolume * (listener.aboard ? kThroughCabin : 1);
  play(birds_, kBirds, share * around.birds);
  play(water_, kWater, share * around.water);
}

}  // namespace skydrop::audio
