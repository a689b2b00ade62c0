// The world of a scene and whoever flies it: the player, the autopilot or a replay; each can be recorded. No
// graphics. Main thread.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/session/flight_recorder.h"
#include "app/session/forecast_in_force.h"
#include "app/session/land_files.h"
#include "app/settings/settings.h"
#include "app/settings/settings_change.h"
#include "skydrop/clouds/cloud_field.h"
#include "skydrop/core/cpu_meter.h"
#include "skydrop/core/frame_statistics.h"
#include "skydrop/game/autopilot.h"
#include "skydrop/game/flight_assist.h"
#include "skydrop/game/input_log.h"
#include "skydrop/game/world.h"
#include "skydrop/scene/scene.h"
#include "skydrop/terrain/height_source.h"

namespace skydrop::app {

enum class Pilot { player, autopilot, replay };

struct SimulationSetup {
  scene::Scene scene;
  std::uint64_t seed = 1;
  Pilot pilot = Pilot::player;
  std::optional<game::InputLog> replay;  // with Pilot::replay
  std::string replayFile;                // named in errors
  std::string replayDoubt;  // why the replay may differ (another version, --set), for the line that says so
  FlightRecorder* recorder = nullptr;                 // outlives the simulation; begins with it
  std::shared_ptr<const weather::Forecast> forecast;  // of weather files; null: there are none
  bool forecastsCome = false;                         // newer ones, while flying: see takeForecast()
  std::vector<game::InputLog::WeatherRecord> weatherRecords,
      farWeatherRecords;  // of those files, for the log
  LandFiles land;
};

// Why the setting cannot change in this flight, empty if it can: what would load it again during a recording
// (a log has no other land than that it began with), and in a replay all that decides the simulation.
std::string_view whyFixed(const SimulationSetup& setup, const core::Field& field);

class Simulation {
 public:
  // Keeps the table, which must outlive it: a replay changes settings as the log says. Throws core::DataError
  // and core::RangeError.
  Simulation(const SimulationSetup& setup, Settings& settings, const core::SettingsTable& table);
  ~Simulation();

  // One step of 1/120 s, recorded and compared with the replay's checkpoints. The player's controls count
  // only where the player flies.
  void step(const game::Controls& player);

  // Of a replay: whether the log has ended.
  bool finished() const;

  const game::World& world() const { return world_; }
  // Adds to a snapshot of this flight what a view of it shows besides: how near the ground ahead is.
  void warnOfGround(game::Snapshot& shown) const;
  game::World& world() { return world_; }
  const std::shared_ptr<const terrain::HeightSource>& ground() const { return ground_; }
  const std::vector<std::shared_ptr<const elevation::AerialImage>>& images() const {
    return setup_.land.images;
  }
  // Those that are on and have something to do (scene::effective).
  const scene::EffectSet& effects() const { return effects_; }
  Pilot pilot() const { return setup_.pilot; }

  // Before a change of settings takes effect: gives those that cannot change in this flight the values back
  // that they are flown with. Returns the reasons, each once, and removes them from `change`.
  std::vector<std::string> takeBackFixed(SettingsChange& change);

  // After the menu or a file changed settings: hands them to the world, and to the recorder those of the
  // change that decide the simulation. Throws core::RangeError, and changes nothing, where an effect is on
  // that rests on one that is off.
  void apply(const SettingsChange& change);

  // A newer forecast takes over from the one in force, in LiveSettings::blendSeconds; its hours go on
  // counting from where those of the first did. Returns it as it is flown in from now on. Not while a flight
  // is recorded, and not during a handover.
  std::shared_ptr<const weather::Forecast> takeForecast(const weather::Forecast& next);
  bool isHandingOver() const { return inForce_.handover() != nullptr; }

  // Of a replay: what its log has changed since the last call, for whoever else depends on it.
  SettingsChange takeLoggedChange() { return std::exchange(loggedChange_, {}); }

  // The end of the flight, for the recorder.
  void endRecording();

  // Of a replay: whether it has left the recorded flight; and the line that says where first, once.
  bool hasDiverged() const { return hasDiverged_; }
  std::optional<std::string> takeDivergence();

  // Measures the CPU time of steps from the next one on, or no longer; no state depends on it.
  void setMeasuring(bool measuring);
  // CPU time of all steps that were measured, ms: of parts of the world, and of everything.
  game::StepCosts costs() const { return world_.costs(); }
  double costMs() const { return cost_.ms(); }

  // Adds what its parts cost of a second of simulation to their rows of the bill.
  void writeTo(core::FrameStatistics& statistics) const;

 private:
  void advance(const game::Controls& player);
  void applyToWorld();
  void applyWeather();
  void applyGear();
  void applyObstacles();
  void applyEffects();
  void keepFlownValues();
  void beginRecording();
  void compareWithReplay();

  SimulationSetup setup_;
  Settings* settings_;
  const core::SettingsTable* table_;
  scene::EffectSet effects_;
  std::shared_ptr<const terrain::HeightSource> ground_;
  std::shared_ptr<const terrain::Places> places_;          // of the ground; null: there are none
  std::shared_ptr<const clouds::PackedCloudNoise> noise_;  // of the clouds that are flown in; null before
  ForecastInForce inForce_;
  game::World world_;
  std::optional<game::Autopilot> autopilot_;
  game::FlightAssist assist_;  // of the player
  std::optional<game::InputReplay> replay_;
  std::vector<double> flownValues_;                         // of the table's fields
  std::optional<game::InputLog::Checkpoint> beforeChange_;  // the state that the last change of settings met
  SettingsChange loggedChange_;
  core::CpuMeter cost_;  // of whole steps
  bool hasDiverged_ = false;
  std::optional<std::string> divergence_;
};

}  // namespace skydrop::app
