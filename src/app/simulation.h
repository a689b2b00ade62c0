// The world of a scene and whoever flies it: the player, the autopilot or a replay; and the recorder of all
// three. No graphics. Main thread.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/settings.h"
#include "skydrop/core/frame_statistics.h"
#include "skydrop/game/autopilot.h"
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
  bool record = false;
};

class Simulation {
 public:
  // Keeps the table, which must outlive it: a replay changes settings as the log says. Throws core::DataError
  // and core::RangeError.
  Simulation(const SimulationSetup& setup, Settings& settings, const core::SettingsTable& table);
  ~Simulation();

  // One step of 1/120 s. The player's controls count only where the player flies.
  void step(const game::Controls& player);

  // Of a replay: whether the log has ended.
  bool finished() const;

  const game::World& world() const { return world_; }
  game::World& world() { return world_; }
  const std::shared_ptr<const terrain::HeightSource>& ground() const { return ground_; }
  const scene::EffectSet& effects() const { return effects_; }
  Pilot pilot() const { return setup_.pilot; }

  // After the menu or a file changed settings: hands them to the world, and to the recorder those of
  // `changedPaths` that decide the simulation.
  void applySettings(const std::vector<std::string>& changedPaths);

  // What was flown so far; only where `record` was asked for.
  game::InputLog recording() const;

  void writeTo(core::FrameStatistics& statistics) const;

 private:
  void applyToWorld();

  SimulationSetup setup_;
  Settings* settings_;
  const core::SettingsTable* table_;
  scene::EffectSet effects_;
  std::shared_ptr<const terrain::HeightSource> ground_;
  game::World world_;
  std::optional<game::Autopilot> autopilot_;
  std::optional<game::InputReplay> replay_;
  game::InputLog recording_;
};

}  // namespace skydrop::app
