// The world as it runs: clock, aircraft, packages, targets, score. No graphics and no real time: one call of
// step() is 1/120 s, whoever calls it. Seed, settings and the sequence of controls decide every bit of every
// later state, whatever the frame rate or the number of threads around it; stateHash() shows it.
//
// The scoring rule (docs/flight.md gives the reasons):
//  - a package belongs to the target that was current when it was released, and scores when it lands inside
//    that target's radius; any other landing is a miss. Where the aircraft is does not matter.
//  - a drop is "at the target" when the predicted landing point lay inside the radius at the release, which
//    is when the drop text shows: then the next target is drawn at once.
//  - any other drop is "elsewhere" and keeps the target. Should it land inside after all, it scores and the
//    next target is drawn at the landing, so that no target scores twice from drops made in turn.
//  - without a target packages fall, and nothing scores.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "skydrop/core/wind.h"
#include "skydrop/flight/airplane_settings.h"
#include "skydrop/flight/gear_settings.h"
#include "skydrop/flight/package_settings.h"
#include "skydrop/game/controls.h"
#include "skydrop/game/delivery.h"
#include "skydrop/game/events.h"
#include "skydrop/game/game_settings.h"
#include "skydrop/game/snapshot.h"
#include "skydrop/weather/forecast.h"
#include "skydrop/weather/handover.h"
#include "skydrop/weather/weather_settings.h"

namespace skydrop::terrain {
class HeightSource;
class Places;
class Woods;
}  // namespace skydrop::terrain
namespace skydrop::clouds {
struct PackedCloudNoise;
}

namespace skydrop::game {

// Where the aircraft starts and R brings it back to. Angles in degrees; heading by compass. Flying level at
// `speed` along its nose.
struct StartPose {
  glm::dvec3 position{0, 500, 0};
  bool aboveGround = true;  // position.y counts from the surface (land or sea) below, else from the sea level
  double headingDeg = 0;
  double pitchDeg = 0;
  double bankDeg = 0;
  double speed = 70;  // m/s
  // At rest on the wheels instead, where the flight has a gear: of `position` only x and z count, of the
  // attitude the heading, and there is no speed.
  bool onWheels = false;
};

// The weather that is flown in.
struct WeatherSetup {
  weather::WeatherSettings settings;
  core::WindSettings drift;                                     // that carries the clouds
  std::shared_ptr<const clouds::PackedCloudNoise> noise;        // of the clouds; null: none are met
  std::shared_ptr<const weather::Forecast> forecast = nullptr;  // in place of the settings' sites; null: none
  weather::ForecastClock clock = {};                            // of the forecast
  std::shared_ptr<const weather::Handover> handover = nullptr;  // of another weather to this one
  weather::LayerLook lowLook = {};                              // of the low layer, everywhere

  // The weather at a place and time, of the forecast or the sites (weather::stateAt), with that look.
  weather::State at(std::uint64_t seed, double seconds, const glm::dvec2& xz) const;
};

struct WorldSetup {
  std::shared_ptr<const terrain::HeightSource> ground;  // never null; the surface is max(its height, 0 = sea)
  std::uint64_t seed = 1;                               // of the targets
  bool hasAircraft = true;                              // without: only the clock runs
  bool hasTargets = true;  // without: packages drop, nothing scores, no landing is predicted
  StartPose start;
  glm::dvec3 wind{0};  // velocity of the air, m/s, world axes; everywhere the same (core::flownWind)
  std::optional<WeatherSetup> weather = std::nullopt;  // instead of `wind`; without: air of the sea's level
  flight::AirplaneSettings airplane;
  flight::PackageSettings package;
  GameSettings game;
  DeliverySettings delivery = {};
  std::optional<flight::GearSettings> gear = std::nullopt;  // without: whatever touches the ground crashes
  std::shared_ptr<const terrain::Woods> woods = nullptr;    // of this ground; null: no tree is in the way
  std::shared_ptr<const terrain::Places> places = nullptr;  // likewise; null: no house is in the way
  bool keepsBursts = false;  // whether snapshots tell what is thrown up from land and water
  bool alpineBelts = false;  // of the ground, for the colour of what is thrown up: as of terrain::Woods
};

// CPU time of the steps that were measured (World::setMeasuring), on the thread that made them.
struct StepCosts {
  double weatherMs = 0;   // the air that the aircraft meets
  double aircraftMs = 0;  // flight and contact of the aircraft
  double targetsMs = 0;   // targets, packages, prediction of their landing
};

class World {
 public:
  // Throws core::RangeError when the setup is unusable (no ground, values that are not finite, no mass).
  explicit World(const WorldSetup& setup);
  ~World();
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;

  // Advances by 1/120 s. Never throws on account of the controls: they are quantised first (controls.h).
  void step(const Controls& controls);

  // The states after the last step and after the one before it.
  const Snapshot& now() const;
  const Snapshot& before() const;
  // Between the two: alpha 0 is before(), 1 is now(), clamped. Where something was placed again it is at
  // now().
  Snapshot interpolated(double alpha) const;

  // The events since the last call, in order (the newest 1024).
  std::vector<GameEvent> takeEvents();

  // What came of the packages so far, in the order of their landings: the newest kMostDeliveries.
  const std::vector<Delivery>& deliveries() const;

  // Digest of everything that decides the future (not of what is derived from it).
  std::uint64_t stateHash() const;
  std::uint64_t stepCount() const;

  // Measures what steps cost from the next one on, or no longer; no state depends on it.
  void setMeasuring(bool measuring);
  StepCosts costs() const;

  // Live changes, from the next step on. An input log records them too (input_log.h), or a replay would
  // differ. Each throws core::RangeError, and changes nothing, when a value is unusable.
  void apply(const flight::AirplaneSettings& settings);
  void apply(const flight::PackageSettings& settings);
  void apply(const GameSettings& settings);
  void apply(const DeliverySettings& settings);
  // None: the gear is gone, and whatever touches the ground crashes. An aircraft on its wheels is then lifted
  // and flies on level.
  void setGear(const std::optional<flight::GearSettings>& gear);
  // Null: no tree is in the way any more.
  void setWoods(std::shared_ptr<const terrain::Woods> woods);
  // Null: no house is in the way any more.
  void setPlaces(std::shared_ptr<const terrain::Places> places);
  // What is thrown up from now on is told by snapshots, or none is, of either belts (WorldSetup).
  void setBursts(bool kept, bool alpineBelts);
  void setWind(const glm::dvec3& velocity);  // m/s, as WorldSetup::wind
  void setWeather(const std::optional<WeatherSetup>& weather);

  // What the world is made of, from now on: an aircraft that comes begins at the start, targets begin with
  // the first and a score of 0, packages go with the targets. An aircraft that the new ground would be above,
  // or nearer to than GameSettings::safeHeight, is lifted and flies on level. Throws core::RangeError, and
  // changes nothing, without a ground.
  void setParts(std::shared_ptr<const terrain::HeightSource> ground, bool hasAircraft, bool hasTargets);

  // Places the aircraft, if there is one, again (a pose from the command line or a test). Throws
  // core::RangeError, and changes nothing, unless finite.
  void placeAircraft(const StartPose& pose);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace skydrop::game
