#include "skydrop/game/world.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>

#include "game/deliveries.h"
#include "game/event_log.h"
#include "game/flown_air.h"
#include "game/player_aircraft.h"
#include "game/snapshot_blend.h"
#include "game/state_digest.h"
#include "game/steps.h"
#include "game/surface_bursts.h"
#include "skydrop/core/cpu_meter.h"
#include "skydrop/core/deterministic_math.h"
#include "skydrop/core/error.h"
#include "skydrop/core/guards.h"
#include "skydrop/core/hash.h"
#include "skydrop/terrain/places.h"
#include "skydrop/terrain/woods.h"

namespace skydrop::game {
namespace {

// The predicted landing point is refreshed this often: 7 m of flight at cruise, against a radius of 100.
constexpr std::uint64_t kPredictionSteps = 12;

void requireUsable(const GameSettings& s) {
  for (const double value : {s.targetRadius, s.targetNearest, s.targetFarthest, s.targetSlopeDeg,
                             s.dropCooldown, s.landedPackageSeconds, s.crashSeconds, s.contactHeight,
                             s.safeHeight, s.respawnBackSeconds, s.messageSeconds}) {
    if (!std::isfinite(value) || value < 0) {
      throw core::RangeError("game: every setting must be finite and not negative");
    }
  }
  if (s.targetRadius <= 0) throw core::RangeError("game: targetRadius must be positive");
}

void requireUsable(const DeliverySettings& s) {
  if (!isUsable(s)) throw core::RangeError("delivery: points, share and fade must be finite and in range");
}

void requireUsable(const glm::dvec3& wind) {
  if (!core::isFinite(wind)) throw core::RangeError("world: the wind is not finite");
}

const WorldSetup& usable(const WorldSetup& setup) {
  if (!setup.ground) throw core::RangeError("world: there is no ground");
  requireUsable(setup.wind);
  requireUsable(setup.game);
  requireUsable(setup.delivery);
  if (setup.weather) weather::requireUsable(setup.weather->settings);
  return setup;
}

// A flight without one keeps the digest that it had before there was any.
void addLook(core::StateHasher& h, const weather::LayerLook& look) {
  if (look == weather::LayerLook{}) return;
  for (const double value :
       {look.base, look.thickness, look.cover, look.scale, look.extinction, look.higherScale,
        look.weatherScale, look.erosion, look.threshold, look.typeShift, look.anisotropy, look.forwardShare})
    h.add(value);
}

}  // namespace

weather::State WeatherSetup::at(std::uint64_t seed, double seconds, const glm::dvec2& xz) const {
  weather::State state = weather::stateAt(settings, forecast.get(), clock, handover.get(), seed, seconds, xz);
  weather::lookLow(state, lowLook);
  return state;
}

struct World::State {
  WorldSetup setup;
  std::shared_ptr<const weather::WeatherSettings> shownWeather;  // setup.weather's, shared by snapshots
  core::RandomStream random;
  std::uint64_t steps = 0;
  EventLog eventLog;
  FlownAir air;
  std::optional<PlayerAircraft> aircraft;
  Deliveries deliveries;
  SurfaceBursts bursts;

  // Derived, for the view.
  std::optional<glm::dvec3> predictedLanding;
  Snapshot now, before;

  // Of the parts of a step; nothing else reads them.
  core::CpuMeter weatherCost, aircraftCost, targetsCost;

  explicit State(const WorldSetup& s);
  State(const State&) = delete;  // its parts point at its setup
  State& operator=(const State&) = delete;

  std::optional<glm::dvec3> aircraftPosition() const;
  void advance(const Controls& wanted);
  void predict();
  void noteBursts();
  bool facesTarget() const { return setup.delivery.startFacesTarget && !setup.start.onWheels; }
  void faceTarget();
  void beginAgain();
  void shareWeather();
  void setParts(std::shared_ptr<const terrain::HeightSource> ground, bool hasAircraft, bool hasTargets);
  void showWeather(Snapshot& out) const;
  void fill(Snapshot& out) const;
  std::uint64_t hash() const;
};

World::State::State(const WorldSetup& s)
    : setup(usable(s)),
      random{core::mix64(s.seed), 0},
      air(setup),
      deliveries(setup, air, random, eventLog),
      bursts(setup, air) {
  shareWeather();
  if (setup.hasAircraft) aircraft.emplace(setup, air, eventLog);
  if (setup.hasTargets) deliveries.drawNextTarget(aircraftPosition().value_or(glm::dvec3(0)));
  if (aircraft && facesTarget()) {
    faceTarget();
    aircraft->place(setup.start, 0);
  }
  predict();
  fill(now);
  before = now;
}

// From the start on the target lies ahead. Straight above it any way is as good.
void World::State::faceTarget() {
  const std::optional<glm::dvec3> target = deliveries.target();
  if (!target) return;
  const double east = target->x - setup.start.position.x, south = target->z - setup.start.position.z;
  if (east == 0 && south == 0) return;
  setup.start.headingDeg = core::dmath::atan2(east, -south) / core::dmath::kRadPerDeg;
}

// After a reset the way is as long as at first: a target that lies elsewhere by now is left.
void World::State::beginAgain() {
  const std::optional<glm::dvec3> target = deliveries.target();
  const glm::dvec3 start = aircraft->body().position;
  const auto isInReach = [&](const glm::dvec3& place) {
    return glm::length(glm::dvec2(place.x - start.x, place.z - start.z)) <= setup.game.targetFarthest;
  };
  if (setup.hasTargets && target && !isInReach(*target)) deliveries.drawNextTarget(start);
  faceTarget();
  aircraft->place(setup.start, steps);
}

std::optional<glm::dvec3> World::State::aircraftPosition() const {
  if (!aircraft) return {};
  return aircraft->body().position;
}

void World::State::advance(const Controls& wanted) {
  eventLog.beginStep(++steps);
  deliveries.coolDown();
  bool moved = false;  // otherwise than by flying
  if (aircraft) {
    const std::uint32_t spawned = aircraft->spawnCount();
    weatherCost.measure([&] { air.advance(aircraft->body(), aircraft->clearance(), steps); });
    aircraftCost.measure([&] { aircraft->advance(quantised(wanted), steps); });
    moved = spawned != aircraft->spawnCount() || aircraft->crashed();
    if (aircraft->wasReset() && facesTarget()) beginAgain();
  }
  targetsCost.measure([&] {
    if (aircraft && aircraft->dropPressed() && aircraft->canDrop()) deliveries.drop(aircraft->body());
    deliveries.step(aircraftPosition(), steps);
    if (steps % kPredictionSteps == 0 || moved) predict();
  });
}

void World::State::noteBursts() {
  bursts.step(secondsOf(steps), eventLog.ofStep(), before, aircraft ? &now.aircraft : nullptr);
  now.bursts = bursts.all();
}

void World::State::shareWeather() {
  shownWeather =
      setup.weather ? std::make_shared<const weather::WeatherSettings>(setup.weather->settings) : nullptr;
}

void World::State::predict() {
  predictedLanding.reset();
  if (setup.hasTargets && aircraft && aircraft->canDrop())
    predictedLanding = deliveries.predictLanding(aircraft->body());
}

void World::State::setParts(std::shared_ptr<const terrain::HeightSource> ground, bool hasAircraft,
                            bool hasTargets) {
  const bool newGround = ground != setup.ground;
  const bool newTargets = hasTargets && (!setup.hasTargets || newGround);
  setup.ground = std::move(ground);
  setup.hasAircraft = hasAircraft;
  if (!hasAircraft) {
    aircraft.reset();
  } else if (!aircraft) {
    aircraft.emplace(setup, air, eventLog);
  } else if (newGround) {
    aircraft->clearGround(steps);
  }
  if (newTargets || (setup.hasTargets && !hasTargets)) deliveries = Deliveries(setup, air, random, eventLog);
  setup.hasTargets = hasTargets;
  bursts.clear();
  if (newTargets) deliveries.drawNextTarget(aircraftPosition().value_or(glm::dvec3(0)));
  predict();
  now = before = {};
  fill(now);
  before = now;
}

void World::State::showWeather(Snapshot& out) const {
  out.weather = {};
  if (!shownWeather) return;
  out.weather = {shownWeather,          setup.seed,
                 out.simulatedSeconds,  setup.weather->forecast,
                 setup.weather->clock,  setup.weather->handover,
                 setup.weather->lowLook};
}

void World::State::fill(Snapshot& out) const {
  out.stepCount = steps;
  out.simulatedSeconds = secondsOf(steps);
  out.wind = setup.wind;
  showWeather(out);
  out.air = {};
  if (aircraft) {
    out.aircraft = aircraft->snapshot();
    out.air = air.snapshot(aircraft->body());
    if (out.air.present) out.wind = out.air.wind;
  }
  deliveries.fill(out, aircraftPosition());
  out.predictedLanding = predictedLanding;
  out.bursts = bursts.all();  // until those of the step are added
  out.dropZone = predictedLanding && deliveries.isInTarget(*predictedLanding);
  out.messages = eventLog.messages();
}

std::uint64_t World::State::hash() const {
  core::StateHasher h;
  h.add(steps), h.add(random.seed), h.add(random.counter);
  addTo(h, setup.wind);
  WorldSetup copy = setup;  // describe() wants something it could write to
  HashingVisitor settings(h);
  describe(settings, copy.airplane), describe(settings, copy.package), describe(settings, copy.game);
  if (copy.weather) {  // a flight without keeps the digest that it had before there was any
    describe(settings, copy.weather->settings);
    describe(settings, copy.weather->drift);
    h.add(std::uint64_t{copy.weather->noise != nullptr});
    if (copy.weather->forecast) {
      h.add(copy.weather->forecast->digest);
      describe(settings, copy.weather->clock);
    }
    if (const weather::Handover* handover = copy.weather->handover.get()) {
      h.add(handover->from ? handover->from->digest : 0);
      weather::ForecastClock clock = handover->clock;
      describe(settings, clock);
      h.add(handover->beginSeconds), h.add(handover->lastsSeconds);
    }
    addLook(h, copy.weather->lowLook);
    if (aircraft) air.addTo(h);
  }
  if (copy.gear) describe(settings, *copy.gear);
  if (copy.woods) h.add(copy.woods->density());
  if (copy.woods && copy.woods->places()) h.add(copy.woods->places()->settings().density);
  if (copy.places) h.add(copy.places->settings().density), h.add(copy.places->settings().fields);
  if (aircraft) aircraft->addTo(h);
  deliveries.addTo(h);
  return h.value();
}

World::World(const WorldSetup& setup) : state_(std::make_unique<State>(setup)) {}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

void World::step(const Controls& controls) {
  state_->advance(controls);
  std::swap(state_->now, state_->before);
  state_->fill(state_->now);
  if (state_->setup.keepsBursts) state_->noteBursts();
}

const Snapshot& World::now() const { return state_->now; }
const Snapshot& World::before() const { return state_->before; }
Snapshot World::interpolated(double alpha) const { return blended(state_->before, state_->now, alpha); }
std::vector<GameEvent> World::takeEvents() { return state_->eventLog.takeEvents(); }
const std::vector<Delivery>& World::deliveries() const { return state_->deliveries.log(); }
std::uint64_t World::stateHash() const { return state_->hash(); }
std::uint64_t World::stepCount() const { return state_->steps; }

void World::setMeasuring(bool measuring) {
  state_->weatherCost.setMeasuring(measuring);
  state_->aircraftCost.setMeasuring(measuring);
  state_->targetsCost.setMeasuring(measuring);
}

StepCosts World::costs() const {
  return {state_->weatherCost.ms(), state_->aircraftCost.ms(), state_->targetsCost.ms()};
}

void World::apply(const flight::AirplaneSettings& settings) {
  if (state_->aircraft) state_->aircraft->apply(settings);
  state_->setup.airplane = settings;
}

void World::apply(const flight::PackageSettings& settings) {
  flight::Package(settings, {});  // throws when they are unusable
  state_->setup.package = settings;
}

void World::apply(const GameSettings& settings) {
  requireUsable(settings);
  state_->setup.game = settings;
}

void World::apply(const DeliverySettings& settings) {
  requireUsable(settings);
  state_->setup.delivery = settings;
}

void World::setGear(const std::optional<flight::GearSettings>& gear) {
  state_->setup.gear = gear;
  if (state_->aircraft) state_->aircraft->applyGear(state_->steps);
}

void World::setPlaces(std::shared_ptr<const terrain::Places> places) {
  state_->setup.places = std::move(places);
}
void World::setWoods(std::shared_ptr<const terrain::Woods> woods) { state_->setup.woods = std::move(woods); }

void World::setBursts(bool kept, bool alpineBelts) {
  if (kept == state_->setup.keepsBursts && alpineBelts == state_->setup.alpineBelts) return;
  state_->setup.keepsBursts = kept;
  state_->setup.alpineBelts = alpineBelts;
  state_->bursts.clear();
}
void World::setWind(const glm::dvec3& velocity) {
  requireUsable(velocity);
  state_->setup.wind = velocity;
}

void World::setWeather(const std::optional<WeatherSetup>& weather) {
  if (weather) weather::requireUsable(weather->settings);
  const bool comesOrGoes = weather.has_value() != state_->setup.weather.has_value();
  state_->setup.weather = weather;
  state_->shareWeather();
  if (comesOrGoes && state_->aircraft) state_->aircraft->meetAir(state_->steps);
  // Seen at once where time is held.
  state_->showWeather(state_->now), state_->showWeather(state_->before);
}

void World::setParts(std::shared_ptr<const terrain::HeightSource> ground, bool hasAircraft, bool hasTargets) {
  if (!ground) throw core::RangeError("world: there is no ground");
  state_->setParts(std::move(ground), hasAircraft, hasTargets);
}

void World::placeAircraft(const StartPose& pose) {
  if (!state_->aircraft) return;
  state_->aircraft->place(pose, state_->steps);
  state_->predict();
  state_->fill(state_->now);
  state_->before = state_->now;
}

}  // namespace skydrop::game
