#include "app/simulation.h"

#include <glm/trigonometric.hpp>
#include <algorithm>

#include "app/version.h"
#include "skydrop/core/guards.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/terrain/noise_height_source.h"

namespace skydrop::app {
namespace {

using scene::Effect;

std::shared_ptr<const terrain::HeightSource> makeGround(const scene::EffectSet& effects, const Settings& settings,
                                                        std::uint64_t seed) {
  if (!effects.contains(Effect::terrain)) return terrain::makeFlatSource(0);
  return terrain::makeNoiseHeightSource(settings.terrain, seed);
}

game::WorldSetup worldSetup(const SimulationSetup& setup, const scene::EffectSet& effects, const Settings& settings,
                            std::shared_ptr<const terrain::HeightSource> ground) {
  game::WorldSetup world;
  world.ground = std::move(ground);
  world.seed = setup.seed;
  world.hasAircraft = effects.contains(Effect::aircraft);
  world.hasTargets = effects.contains(Effect::targets);
  world.start.position = setup.scene.start.position;
  world.start.aboveGround = effects.contains(Effect::terrain);
  world.start.headingDeg = setup.scene.start.headingDegrees;
  world.start.speed = setup.scene.start.speedMps;
  world.airplane = settings.aircraft;
  world.package = settings.package;
  world.game = settings.game;
  return world;
}

}  // namespace

Simulation::Simulation(const SimulationSetup& setup, Settings& settings, const core::SettingsTable& table)
    : setup_(setup),
      settings_(&settings),
      table_(&table),
      effects_(scene::requiredEffects(setup.scene)),
      ground_(makeGround(effects_, settings, setup.seed)),
      world_(worldSetup(setup, effects_, settings, ground_)) {
  if (setup_.pilot == Pilot::autopilot) autopilot_.emplace(ground_, settings.autopilot);
  if (setup_.pilot == Pilot::replay) replay_.emplace(*setup_.replay);
  if (setup_.record) {
    recording_.program = std::string("skydrop ") + kVersion;
    recording_.scene = setup_.scene.name;
    recording_.seed = setup_.seed;
    recording_.settings = simulationSettings(table);
  }
}

Simulation::~Simulation() = default;

void Simulation::step(const game::Controls& player) {
  game::Controls controls = player;
  if (autopilot_) controls = autopilot_->decide(world_.now());
  if (replay_) {
    const std::vector<game::SettingOverride> changes = replay_->changesDue();
    if (!changes.empty()) {
      applyLogged(*table_, changes, setup_.replayFile);
      applyToWorld();
    }
    controls = replay_->next();
  }
  if (setup_.record) recording_.append(controls);
  world_.step(controls);
}

bool Simulation::finished() const { return replay_ && replay_->finished(); }

void Simulation::applySettings(const std::vector<std::string>& changedPaths) {
  applyToWorld();
  if (!setup_.record) return;
  for (const std::string& path : changedPaths) {
    if (decidesSimulation(path)) recording_.appendChange({path, core::fieldText(table_->at(path))});
  }
}

void Simulation::applyToWorld() {
  world_.apply(settings_->aircraft);
  world_.apply(settings_->package);
  world_.apply(settings_->game);
  if (autopilot_) autopilot_->apply(settings_->autopilot);
}

game::InputLog Simulation::recording() const {
  game::InputLog log = recording_;
  log.finalHash = world_.stateHash();
  return log;
}

void Simulation::writeTo(core::FrameStatistics& statistics) const {
  const game::Snapshot& now = world_.now();
  statistics.game.score = now.score;
  statistics.game.drops = now.drops;
  statistics.game.misses = now.misses;
  statistics.game.targets = now.target.id;
  for (int i = 0; i < 3; ++i) statistics.game.position[i] = now.aircraft.position[i];
  statistics.game.airspeedMps = now.aircraft.airspeedMps;
  statistics.game.throttle = now.aircraft.throttle;
  statistics.game.headingDeg = glm::degrees(now.aircraft.headingRad);
  statistics.game.pitchDeg = glm::degrees(now.aircraft.pitchRad);
  statistics.game.bankDeg = glm::degrees(now.aircraft.bankRad);
  for (std::size_t i = 0; i < scene::kEffectNames.size(); ++i) {
    if (effects_.contains(static_cast<Effect>(i))) statistics.effects.emplace_back(scene::kEffectNames[i]);
  }
  for (int i = 0; i < static_cast<int>(core::Guard::count_); ++i) {
    const auto guard = static_cast<core::Guard>(i);
    if (const std::uint64_t count = core::guardCount(guard); count > 0) {
      statistics.guards[std::string(core::guardName(guard))] = static_cast<std::int64_t>(count);
    }
  }
  statistics.steps = now.stepCount;
  statistics.stateHash = world_.stateHash();
}

}  // namespace skydrop::app
