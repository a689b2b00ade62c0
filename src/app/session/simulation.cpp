#include "app/session/simulation.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <glm/trigonometric.hpp>
#include <utility>

#include "app/measure/bill.h"
#include "app/session/flown_weather.h"
#include "app/session/ground.h"
#include "app/types/version.h"
#include "skydrop/core/deterministic_math.h"
#include "skydrop/core/fixed_step.h"
#include "skydrop/core/guards.h"
#include "skydrop/terrain/places.h"
#include "skydrop/terrain/strips.h"
#include "skydrop/terrain/woods.h"

namespace skydrop::app {
namespace {

using scene::Effect;

// The forecast that there is, unless the weather is made by hand.
std::shared_ptr<const weather::Forecast> followed(const SimulationSetup& setup, const Settings& settings) {
  return settings.live.follow ? setup.forecast : nullptr;
}

// At the nearest strip, if the land has one within reach; else the start stays.
void startAtStrip(scene::StripStart where, game::WorldSetup& world) {
  const terrain::Strips* strips = world.ground->strips();
  if (!strips) return;
  constexpr double kReach = 60000, kFinalMetres = 1500, kFinalSlope = 0.06, kBeginMetres = 25;
  const auto strip = strips->nearest({world.start.position.x, world.start.position.z}, kReach);
  if (!strip) return;
  world.start.headingDeg = strip->headingRad() / core::dmath::kRadPerDeg;
  const bool stands = where == scene::StripStart::standing && world.gear;
  const double before = stands ? -kBeginMetres : kFinalMetres;
  const glm::dvec2 xz = strip->world(-strip->halfLength - before, 0);
  world.start.position = {xz.x, strip->heightAt(-strip->halfLength) + kFinalSlope * kFinalMetres, xz.y};
  world.start.aboveGround = false;
  world.start.onWheels = stands;
}

// Those of the land, whether or not they are obstacles; null where there are none.
std::shared_ptr<const terrain::Places> settledPlaces(const scene::EffectSet& effects,
                                                     const Settings& settings,
                                                     std::shared_ptr<const terrain::HeightSource> ground) {
  if (!effects.contains(Effect::places) || settings.villages.density <= 0) return {};
  return std::make_shared<const terrain::Places>(std::move(ground), settings.villages);
}

// Null where no tree is in the way.
std::shared_ptr<const terrain::Woods> standingWoods(const scene::EffectSet& effects, const Settings& settings,
                                                    std::shared_ptr<const terrain::HeightSource> ground,
                                                    std::shared_ptr<const terrain::Places> places) {
  if (!effects.contains(Effect::vegetation) || !settings.woods.obstacles || settings.woods.density <= 0)
    return {};
  const bool isOfTheEarth = hasAlpineBelts(*ground);
  return std::make_shared<const terrain::Woods>(std::move(ground), settings.woods.density, isOfTheEarth,
                                                std::move(places));
}

game::WorldSetup worldSetup(const SimulationSetup& setup, const scene::EffectSet& effects,
                            const Settings& settings, std::shared_ptr<const terrain::HeightSource> ground,
                            std::shared_ptr<const clouds::PackedCloudNoise>& noise) {
  game::WorldSetup world;
  world.ground = std::move(ground);
  world.seed = setup.seed;
  world.hasAircraft = effects.contains(Effect::aircraft);
  world.hasTargets = effects.contains(Effect::targets);
  if (effects.contains(Effect::groundHandling)) world.gear = settings.gear;
  const auto places = settledPlaces(effects, settings, world.ground);
  world.woods = standingWoods(effects, settings, world.ground, places);
  if (settings.villages.obstacles) world.places = places;
  world.keepsBursts = effects.contains(Effect::dustAndSpray);
  world.alpineBelts = world.keepsBursts && hasAlpineBelts(*world.ground);
  world.start.position = setup.scene.start.position;
  world.start.aboveGround = effects.contains(Effect::terrain);
  world.start.headingDeg = setup.scene.start.headingDegrees;
  world.start.speed = setup.scene.start.speedMps;
  if (setup.scene.start.strip != scene::StripStart::none) startAtStrip(setup.scene.start.strip, world);
  world.wind = core::flownWind(settings.wind);
  world.weather = flownWeather(effects, settings, noise, followed(setup, settings));
  if (world.weather && setup.forecastsCome && !noise) world.weather->noise = noise = readFlownNoise();
  world.airplane = settings.aircraft;
  world.package = settings.package;
  world.game = settings.game;
  world.delivery = settings.delivery;
  return world;
}

// Sets the rows of the forecast's clock to that of the sky; a replay has them from its log.
Settings& followingSky(const SimulationSetup& setup, Settings& settings) {
  if (setup.forecast && setup.pilot != Pilot::replay)
    settings.weatherFile = forecastClock(settings, *setup.forecast);
  return settings;
}

}  // namespace

std::string_view whyFixed(const SimulationSetup& setup, const core::Field& field) {
  if (setup.pilot == Pilot::replay && decidesSimulation(field.path))
    return "A replay flies with the recorded settings";
  if (setup.recorder && field.takesEffect == core::TakesEffect::restart)
    return "The land keeps its shape while a flight is recorded";
  if (setup.recorder && switchesSimulation(field.path))
    return "Aircraft, targets, terrain, weather, gear, trees and villages stay as they are while a flight is "
           "recorded";
  return {};
}

Simulation::Simulation(const SimulationSetup& setup, Settings& settings, const core::SettingsTable& table)
    : setup_(setup),
      settings_(&followingSky(setup, settings)),
      table_(&table),
      effects_(scene::effective(settings.effects.set())),
      ground_(makeGround(effects_, settings, setup)),
      inForce_(followed(setup, settings), settings.weatherFile),
      world_(worldSetup(setup, effects_, settings, ground_, noise_)) {
  if (setup_.pilot == Pilot::autopilot) autopilot_.emplace(ground_, settings.autopilot);
  applyObstacles();
  if (setup_.pilot == Pilot::replay) replay_.emplace(*setup_.replay);
  keepFlownValues();
  if (setup_.recorder) beginRecording();
  if (replay_) compareWithReplay();
}

Simulation::~Simulation() = default;

void Simulation::beginRecording() {
  game::InputLog start;
  start.program = programName();
  start.scene = {setup_.scene.source, setup_.scene.text};
  start.weather = setup_.weatherRecords;
  start.farWeather = setup_.farWeatherRecords;
  start.elevation = setup_.land.records;
  start.seed = setup_.seed;
  start.settings = simulationSettings(*table_);
  setup_.recorder->begin(start, world_.stateHash());
}

void Simulation::setMeasuring(bool measuring) {
  cost_.setMeasuring(measuring);
  world_.setMeasuring(measuring);
}

void Simulation::step(const game::Controls& player) {
  cost_.measure([&] { advance(player); });
  cost_.endRound();
}

void Simulation::advance(const game::Controls& player) {
  game::Controls controls = player;
  if (autopilot_) controls = autopilot_->decide(world_.now());
  if (setup_.pilot == Pilot::player) controls = assist_.decide(world_.now(), player, settings_->assist);
  if (replay_) {
    const std::vector<game::SettingOverride> changes = replay_->changesDue();
    if (!changes.empty()) {
      applyLogged(*table_, changes, setup_.replayFile);
      applyToWorld();
      applyEffects();
      for (const game::SettingOverride& change : changes) {
        loggedChange_.add(table_->at(change.path).path);
        if (setup_.recorder) setup_.recorder->change(change);
      }
    }
    controls = replay_->next();
  }
  if (!effects_.contains(Effect::targets)) controls.drop = false;  // packages come with the targets
  if (setup_.recorder) setup_.recorder->step(controls);
  world_.step(controls);
  if (inForce_.endHandover(world_.now().simulatedSeconds)) applyWeather();
  if (setup_.recorder && setup_.recorder->checkpointIsDue()) setup_.recorder->checkpoint(world_.stateHash());
  if (replay_) compareWithReplay();
}

bool Simulation::finished() const { return replay_ && replay_->finished(); }

void Simulation::compareWithReplay() {
  while (const std::optional<std::uint64_t> recorded = replay_->hashDue()) {
    const std::uint64_t flown = world_.stateHash();
    if (hasDiverged_ || flown == *recorded) continue;
    hasDiverged_ = true;
    const std::uint64_t step = world_.stepCount();
    std::array<char, 160> text{};
    std::snprintf(
        text.data(), text.size(),
        ": step %llu (%.3f s): the replay differs from the recorded flight: state %016llx, recorded %016llx",
        static_cast<unsigned long long>(step), core::FixedStep::secondsOf(step),
        static_cast<unsigned long long>(flown), static_cast<unsigned long long>(*recorded));
    divergence_ = setup_.replayFile + text.data();
    if (!setup_.replayDoubt.empty()) *divergence_ += " (" + setup_.replayDoubt + ")";
  }
}

std::optional<std::string> Simulation::takeDivergence() { return std::exchange(divergence_, std::nullopt); }

std::vector<std::string> Simulation::takeBackFixed(SettingsChange& change) {
  std::vector<std::string> reasons;
  SettingsChange allowed;
  for (const std::string& path : change.paths()) {
    const core::Field& field = table_->at(path);
    const std::string reason(whyFixed(setup_, field));
    if (reason.empty()) {
      allowed.add(path);
      continue;
    }
    const double flown = flownValues_[static_cast<std::size_t>(&field - table_->fields().data())];
    if (field.get() != flown && std::ranges::find(reasons, reason) == reasons.end())
      reasons.push_back(reason);
    field.set(flown);
  }
  change = allowed;
  return reasons;
}

void Simulation::apply(const SettingsChange& change) {
  requireUsable(settings_->effects);
  requireUsable(settings_->weather);
  if (setup_.recorder && (!beforeChange_ || beforeChange_->step != world_.stepCount()))
    beforeChange_ = {world_.stepCount(), world_.stateHash()};
  const weather::ForecastClock clock = settings_->weatherFile;
  followingSky(setup_, *settings_);
  applyToWorld();
  if (change.touches("effects")) applyEffects();
  if (!setup_.recorder) return;
  SettingsChange all = change;
  if (settings_->weatherFile != clock) all.add(SettingsChange({"weatherFile.hour", "weatherFile.pace"}));
  for (const std::string& path : all.paths()) {
    if (isRecorded(path)) setup_.recorder->change({path, core::fieldText(table_->at(path))});
  }
}

void Simulation::applyToWorld() {
  world_.apply(settings_->aircraft);
  world_.apply(settings_->package);
  world_.apply(settings_->game);
  world_.apply(settings_->delivery);
  applyGear();
  applyObstacles();
  world_.setWind(core::flownWind(settings_->wind));
  applyWeather();
  if (autopilot_) autopilot_->apply(settings_->autopilot);
  keepFlownValues();
}

void Simulation::applyGear() {
  world_.setGear(effects_.contains(Effect::groundHandling) ? std::optional(settings_->gear) : std::nullopt);
}

// Woods and places are values of the ground and the settings: made anew where these are another.
void Simulation::applyObstacles() {
  // What has been found of them is kept.
  const bool isSame = places_ && &places_->ground() == ground_.get() &&
                      places_->settings() == settings_->villages && effects_.contains(Effect::places);
  if (!isSame) places_ = settledPlaces(effects_, *settings_, ground_);
  auto places = places_;
  auto woods = standingWoods(effects_, *settings_, ground_, places);
  if (!settings_->villages.obstacles) places = nullptr;
  if (autopilot_) {
    autopilot_->setObstacleHeight(
        std::max(woods ? terrain::kTallestTreeM : 0, places ? terrain::kTallestHouseM : 0));
  }
  world_.setWoods(std::move(woods));
  world_.setPlaces(std::move(places));
}

void Simulation::applyWeather() {
  const double blend = effects_.contains(Effect::weather) ? settings_->live.blendSeconds : 0;
  inForce_.set(followed(setup_, *settings_), settings_->weatherFile, world_.now().simulatedSeconds, blend);
  std::optional<game::WeatherSetup> weather = flownWeather(effects_, *settings_, noise_, inForce_.forecast());
  if (weather) weather->handover = inForce_.handover();
  world_.setWeather(weather);
}

std::shared_ptr<const weather::Forecast> Simulation::takeForecast(const weather::Forecast& next) {
  setup_.forecast = std::make_shared<const weather::Forecast>(
      setup_.forecast ? weather::continuing(next, *setup_.forecast) : next);
  followingSky(setup_, *settings_);
  applyWeather();
  return setup_.forecast;
}

void Simulation::applyEffects() {
  const scene::EffectSet before = std::exchange(effects_, scene::effective(settings_->effects.set()));
  const auto changes = [&](Effect effect) { return before.contains(effect) != effects_.contains(effect); };
  if (changes(Effect::terrain)) ground_ = makeGround(effects_, *settings_, setup_);
  if (changes(Effect::terrain) || changes(Effect::aircraft) || changes(Effect::targets))
    world_.setParts(ground_, effects_.contains(Effect::aircraft), effects_.contains(Effect::targets));
  if (changes(Effect::weather)) applyWeather();
  if (changes(Effect::groundHandling)) applyGear();
  if (changes(Effect::terrain) && autopilot_) autopilot_.emplace(ground_, settings_->autopilot);
  if (changes(Effect::terrain) || changes(Effect::dustAndSpray)) {
    const bool kept = effects_.contains(Effect::dustAndSpray);
    world_.setBursts(kept, kept && hasAlpineBelts(*ground_));
  }
  if (changes(Effect::terrain) || changes(Effect::vegetation) || changes(Effect::places)) applyObstacles();
}

void Simulation::keepFlownValues() {
  flownValues_.clear();
  for (const core::Field& field : table_->fields()) flownValues_.push_back(field.get());
}

void Simulation::endRecording() {
  if (!setup_.recorder) return;
  // Changes that no step has seen are no part of the flight.
  const bool isChanged = beforeChange_ && beforeChange_->step == world_.stepCount();
  setup_.recorder->end(isChanged ? beforeChange_->hash : world_.stateHash());
}

void Simulation::warnOfGround(game::Snapshot& shown) const {
  shown.pullUpSeconds.reset();
  if (settings_->assist.terrainWarning && effects_.contains(Effect::aircraft))
    shown.pullUpSeconds = game::secondsToGround(*ground_, shown.aircraft, settings_->assist.warningSeconds);
}

void Simulation::writeTo(core::FrameStatistics& statistics) const {
  const game::Snapshot& now = world_.now();
  statistics.game.score = now.score;
  statistics.game.drops = now.drops;
  statistics.game.misses = now.misses;
  statistics.game.targets = now.target.id;
  statistics.game.points = now.points;
  for (const game::Delivery& d : world_.deliveries())
    statistics.game.deliveries.push_back(
        {d.package, d.target, d.hit, d.distanceM, d.seconds, d.points,
         std::string(game::kMissReasonNames[static_cast<std::size_t>(d.reason)])});
  for (int i = 0; i < 3; ++i) statistics.game.position[i] = now.aircraft.position[i];
  statistics.game.airspeedMps = now.aircraft.airspeedMps;
  statistics.game.throttle = now.aircraft.throttle;
  statistics.game.headingDeg = glm::degrees(now.aircraft.headingRad);
  statistics.game.pitchDeg = glm::degrees(now.aircraft.pitchRad);
  statistics.game.bankDeg = glm::degrees(now.aircraft.bankRad);
  for (std::size_t i = 0; i < scene::kEffectNames.size(); ++i) {
    if (effects_.contains(static_cast<Effect>(i))) statistics.effects.emplace_back(scene::kEffectNames[i]);
  }
  const core::GuardCounts guards = core::guardCounts();
  for (std::size_t i = 0; i < guards.size(); ++i) {
    statistics.guards[std::string(core::guardName(static_cast<core::Guard>(i)))] =
        static_cast<std::int64_t>(guards[i]);
  }
  if (cost_.rounds() > 0) {
    const double perSecond = core::FixedStep::kStepsPerSecond / static_cast<double>(cost_.rounds());
    const game::StepCosts costs = world_.costs();
    // What is off has no row of its own that could pay.
    const auto bill = [&](Effect effect, double ms) {
      const std::string_view name = effects_.contains(effect) ? scene::nameOf(effect) : kFrameRow;
      billRow(statistics, name).simulationMs += ms * perSecond;
    };
    bill(Effect::weather, costs.weatherMs);
    bill(Effect::aircraft, costs.aircraftMs);
    bill(Effect::targets, costs.targetsMs);
    const double rest = cost_.ms() - costs.weatherMs - costs.aircraftMs - costs.targetsMs;
    billRow(statistics, kFrameRow).simulationMs += std::max(0.0, rest) * perSecond;
  }
  statistics.steps = now.stepCount;
  statistics.stateHash = world_.stateHash();
}

}  // namespace skydrop::app
