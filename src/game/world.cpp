#include "skydrop/game/world.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <deque>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <utility>

#include "game/targets.h"
#include "skydrop/core/deterministic_math.h"
#include "skydrop/core/error.h"
#include "skydrop/core/fixed_step.h"
#include "skydrop/core/guards.h"
#include "skydrop/core/hash.h"
#include "skydrop/flight/airplane.h"
#include "skydrop/flight/package.h"
#include "skydrop/flight/rotation.h"
#include "skydrop/game/contact.h"

namespace skydrop::game {
namespace {

namespace dmath = core::dmath;
using core::FixedStep;

// The package leaves below the belly, m, body axes.
constexpr glm::dvec3 kBay{0, -1.2, 0};
// The predicted landing point is refreshed this often: 7 m of flight at cruise, against a radius of 100.
constexpr std::uint64_t kPredictionSteps = 12;
// More packages than this in the world at once are not possible (with the cool-down of 2 s: never reached).
constexpr std::size_t kMostPackages = 64;
// Events that nobody takes are kept up to this many, the newest.
constexpr std::size_t kMostEvents = 1024;
// Safe places are noted twice a second and kept for a minute.
constexpr std::uint64_t kSafePlaceSteps = 60;
constexpr std::size_t kSafePlaces = 120;
// A safe place is flown through upright and with speed: sines of bank and pitch, share of the cruise speed.
constexpr double kSafeSineBank = 0.87, kSafeSinePitch = 0.5, kSafeSpeedShare = 0.6;
// The respawn clears the ground of this many seconds of flight ahead, asked every 20 m.
constexpr double kRespawnAheadSeconds = 8, kRespawnAheadMetres = 20;
// Without land in reach a target is searched again so often.
constexpr std::uint64_t kTargetRetrySteps = 1200;
// The propeller turns from 8 to 40 times a second between idle and full.
constexpr double kIdleTurnsPerS = 8, kThrottleTurnsPerS = 32;

std::uint64_t stepsOf(double seconds) {
  return static_cast<std::uint64_t>(std::floor(std::max(seconds, 0.0) * FixedStep::kStepsPerSecond + 0.5));
}

double secondsOf(std::uint64_t steps) { return FixedStep::secondsOf(steps); }

double horizontalDistance(const glm::dvec3& a, const glm::dvec3& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.z - b.z) * (a.z - b.z));
}

// Compass direction of a way, [0, 2 pi); 0 for no way at all.
double bearingOf(const glm::dvec3& way) {
  if (way.x == 0 && way.z == 0) return 0;
  const double bearing = dmath::atan2(way.x, -way.z);
  return bearing < 0 ? std::min(bearing + dmath::kTwoPi, std::nextafter(dmath::kTwoPi, 0.0)) : bearing;
}

std::string withMetres(const char* text, double metres) {
  char line[96];
  std::snprintf(line, sizeof line, text, metres);
  return line;
}

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

// Feeds every described value into a digest.
class HashingVisitor final : public core::SettingsVisitor {
 public:
  explicit HashingVisitor(core::StateHasher& hash) : hash_(&hash) {}
  void number(std::string_view, double& value, const core::NumberInfo&) override { hash_->add(value); }
  void integer(std::string_view, std::int64_t& value, const core::NumberInfo&) override {
    hash_->add(static_cast<std::uint64_t>(value));
  }
  void flag(std::string_view, bool& value, const core::ChoiceInfo&) override {
    hash_->add(std::uint64_t{value});
  }
  void choiceByIndex(std::string_view, std::function<int()> get, std::function<void(int)>,
                     std::span<const std::string_view>, const core::ChoiceInfo&) override {
    hash_->add(static_cast<std::uint64_t>(get()));
  }
  void enterGroup(std::string_view, std::string_view) override {}
  void leaveGroup() override {}

 private:
  core::StateHasher* hash_;
};

void addTo(core::StateHasher& hash, const glm::dvec3& v) { hash.add(v.x), hash.add(v.y), hash.add(v.z); }

void addTo(core::StateHasher& hash, const flight::BodyState& s) {
  addTo(hash, s.position), addTo(hash, s.velocity), addTo(hash, s.angularVelocity);
  hash.add(s.orientation.w), hash.add(s.orientation.x), hash.add(s.orientation.y), hash.add(s.orientation.z);
}

struct Target {
  std::uint32_t id = 0;
  glm::dvec3 position{0};
  double radius = 0;
};

struct FlyingPackage {
  std::uint32_t id = 0;
  flight::Package body;
  std::optional<Target> target;      // the one that was current at the release
  double clearance = 0;              // it is at least so far above the surface
  std::uint64_t stepsToRemoval = 0;  // once landed
  bool onWater = false;
};

struct SafePlace {
  std::uint64_t step = 0;
  glm::dvec3 position{0};
  double headingRad = 0;
};

struct TimedMessage {
  std::string text;
  std::uint64_t stepsLeft = 0;
};

}  // namespace

struct World::State {
  WorldSetup setup;
  core::RandomStream random;
  std::uint64_t steps = 0;

  std::optional<flight::Airplane> airplane;
  Controls controls;
  double clearance = 0;  // of the aircraft's middle above the surface
  double propellerAngleRad = 0;
  bool crashed = false;
  std::uint64_t stepsToRespawn = 0;
  std::uint32_t spawnCount = 0;
  std::deque<SafePlace> safePlaces;  // oldest first; the first may be where the aircraft was placed

  std::vector<FlyingPackage> packages;
  std::optional<Target> target;
  std::uint32_t targetsDrawn = 0;
  std::uint64_t stepsToTargetRetry = 0;
  std::uint64_t stepsToDrop = 0;
  std::int64_t score = 0, drops = 0, misses = 0;

  // Derived, for the view.
  std::optional<glm::dvec3> predictedLanding;
  std::vector<TimedMessage> messages;
  std::vector<GameEvent> events;
  Snapshot now, before;

  explicit State(const WorldSetup& s);

  const terrain::HeightSource& ground() const { return *setup.ground; }
  void advance(const Controls& wanted);
  void place(const StartPose& pose);
  void respawn();
  void put(const glm::dvec3& position, double headingRad, double pitchRad, double bankRad, double speed);
  void flyAircraft();
  void noteSafePlace();
  void crash(const Contact& contact);
  flight::PointState releaseState() const;
  std::optional<glm::dvec3> predict() const;
  void drop();
  void stepPackages();
  void judge(const FlyingPackage& package);
  void drawNextTarget(const glm::dvec3& around);
  void say(std::string text);
  void report(GameEventKind kind, const glm::dvec3& position, std::uint32_t id = 0, double missDistance = 0,
              bool onWater = false);
  void fill(Snapshot& out) const;
  std::uint64_t hash() const;
};

World::State::State(const WorldSetup& s) : setup(s), random{core::mix64(s.seed), 0} {
  if (!setup.ground) throw core::RangeError("world: there is no ground");
  if (!core::isFinite(setup.wind)) throw core::RangeError("world: the wind is not finite");
  requireUsable(setup.game);
  if (setup.hasAircraft) place(setup.start);
  if (setup.hasTargets) drawNextTarget(airplane ? airplane->body().position() : glm::dvec3(0));
  predictedLanding = predict();
  fill(now);
  before = now;
}

void World::State::place(const StartPose& pose) {
  for (const double value : {pose.headingDeg, pose.pitchDeg, pose.bankDeg, pose.speed}) {
    if (!std::isfinite(value)) throw core::RangeError("world: the start pose is not finite");
  }
  if (!core::isFinite(pose.position)) throw core::RangeError("world: the start position is not finite");
  glm::dvec3 position = pose.position;
  const double surface = surfaceAt(ground(), {position.x, position.z}).height;
  if (pose.aboveGround) position.y += surface;
  if (position.y - surface <= setup.game.contactHeight) {  // a pose inside the ground
    position.y = surface + std::max(setup.game.safeHeight, setup.game.contactHeight + 1);
    core::countGuard(core::Guard::respawnRaised);
  }
  put(position, pose.headingDeg * dmath::kRadPerDeg, pose.pitchDeg * dmath::kRadPerDeg,
      pose.bankDeg * dmath::kRadPerDeg, pose.speed);
}

void World::State::put(const glm::dvec3& position, double headingRad, double pitchRad, double bankRad,
                       double speed) {
  flight::BodyState state;
  state.position = position;
  state.orientation = flight::orientationOf({headingRad, pitchRad, bankRad});
  state.velocity = setup.wind + state.orientation * glm::dvec3(0, 0, -speed);
  if (airplane) {
    airplane->place(state);
  } else {
    airplane.emplace(setup.airplane, state);
  }
  clearance = clearanceAt(ground(), position);
  crashed = false;
  stepsToRespawn = 0;
  ++spawnCount;
  safePlaces.clear();
  safePlaces.push_back({steps, position, headingRad});
}

void World::State::respawn() {
  // The newest place that is old enough; else where the aircraft was placed last, which is always first.
  const std::uint64_t back = stepsOf(setup.game.respawnBackSeconds) + stepsOf(setup.game.crashSeconds);
  SafePlace place = safePlaces.front();
  for (const SafePlace& candidate : safePlaces) {
    if (candidate.step + back <= steps) place = candidate;
  }
  const double speed = setup.airplane.cruiseSpeed;
  const glm::dvec2 ahead{dmath::sin(place.headingRad), -dmath::cos(place.headingRad)};
  double needed = -1e300;
  for (double way = 0; way <= speed * kRespawnAheadSeconds; way += kRespawnAheadMetres) {
    const glm::dvec2 at = glm::dvec2(place.position.x, place.position.z) + ahead * way;
    needed = std::max(needed, surfaceAt(ground(), at).height + setup.game.safeHeight);
  }
  if (place.position.y < needed) {
    place.position.y = needed;
    core::countGuard(core::Guard::respawnRaised);
  }
  put(place.position, place.headingRad, 0, 0, speed);
  report(GameEventKind::respawned, place.position);
}

void World::State::advance(const Controls& wanted) {
  const Controls last = std::exchange(controls, quantised(wanted));
  ++steps;
  if (stepsToDrop > 0) --stepsToDrop;
  for (TimedMessage& message : messages) --message.stepsLeft;
  std::erase_if(messages, [](const TimedMessage& message) { return message.stepsLeft == 0; });

  const std::uint32_t spawned = spawnCount;
  if (airplane) {
    if (controls.reset && !last.reset) {
      place(setup.start);
      report(GameEventKind::reset, airplane->body().position());
    } else if (crashed) {
      if (--stepsToRespawn == 0) respawn();
    } else {
      flyAircraft();
    }
    if (controls.drop && !last.drop) drop();
  }
  stepPackages();
  if (setup.hasTargets && !target && stepsToTargetRetry-- == 0) {
    drawNextTarget(airplane ? airplane->body().position() : glm::dvec3(0));
  }
  if (steps % kPredictionSteps == 0 || spawned != spawnCount || crashed) predictedLanding = predict();
}

void World::State::flyAircraft() {
  const glm::dvec3 from = airplane->body().position();
  airplane->step({.thrust = controls.thrust,
                  .brake = controls.brake,
                  .pitch = controls.pitch,
                  .roll = controls.roll,
                  .yaw = controls.yaw},
                 setup.wind, FixedStep::kStepSeconds);
  propellerAngleRad +=
      dmath::kTwoPi * (kIdleTurnsPerS + kThrottleTurnsPerS * airplane->throttle()) * FixedStep::kStepSeconds;
  if (propellerAngleRad >= dmath::kTwoPi) propellerAngleRad -= dmath::kTwoPi;

  const glm::dvec3 to = airplane->body().position();
  const double clearanceBefore = std::exchange(clearance, clearanceAt(ground(), to));
  if (const auto contact =
          sweepContact(ground(), from, to, setup.game.contactHeight, clearanceBefore, clearance)) {
    crash(*contact);
  } else if (steps % kSafePlaceSteps == 0) {
    noteSafePlace();
  }
}

void World::State::noteSafePlace() {
  const flight::BodyState& s = airplane->body().state();
  const glm::dvec3 forward = s.orientation * glm::dvec3(0, 0, -1),
                   right = s.orientation * glm::dvec3(1, 0, 0);
  const glm::dvec3 up = s.orientation * glm::dvec3(0, 1, 0);
  const bool upright = up.y > 0 && std::abs(right.y) < kSafeSineBank && std::abs(forward.y) < kSafeSinePitch;
  const bool fast = glm::length(s.velocity - setup.wind) > kSafeSpeedShare * setup.airplane.cruiseSpeed;
  if (!upright || !fast || clearance < setup.game.safeHeight) return;
  if (safePlaces.size() == kSafePlaces) safePlaces.pop_front();
  safePlaces.push_back({steps, s.position, flight::attitudeOf(s.orientation).headingRad});
}

void World::State::crash(const Contact& contact) {
  flight::BodyState rest = airplane->body().state();
  rest.position = contact.position;
  rest.velocity = rest.angularVelocity = glm::dvec3(0);
  airplane->place(rest);
  clearance = clearanceAt(ground(), contact.position);
  crashed = true;
  stepsToRespawn = std::max<std::uint64_t>(stepsOf(setup.game.crashSeconds), 1);
  say(contact.water ? "Ditched in the sea" : "Crashed into the ground");
  report(GameEventKind::crashed, contact.position, 0, 0, contact.water);
}

flight::PointState World::State::releaseState() const {
  const flight::BodyState& s = airplane->body().state();
  return {s.position + s.orientation * kBay, s.velocity};
}

std::optional<glm::dvec3> World::State::predict() const {
  if (!airplane || crashed) return {};
  const auto landing =
      flight::predictLanding(setup.package, releaseState(), setup.wind,
                             [this](const glm::dvec2& xz) { return surfaceAt(ground(), xz).height; });
  if (!landing) return {};
  return landing->position;
}

void World::State::drop() {
  if (crashed || stepsToDrop > 0) return;
  if (packages.size() >= kMostPackages) {
    say("Too many packages in the air");
    return;
  }
  const flight::PointState release = releaseState();
  flight::BodyState body = airplane->body().state();
  body.position = release.position;
  const auto id = static_cast<std::uint32_t>(++drops);
  packages.push_back(
      {id, flight::Package(setup.package, body), target, clearanceAt(ground(), release.position), 0, false});
  stepsToDrop = stepsOf(setup.game.dropCooldown);
  report(GameEventKind::drop, release.position, id);
  if (!target) return;
  const auto landing = predict();
  if (landing && horizontalDistance(*landing, target->position) <= target->radius) {
    drawNextTarget(airplane->body().position());
  }
}

void World::State::stepPackages() {
  for (FlyingPackage& p : packages) {
    if (p.body.landed()) {
      if (p.stepsToRemoval > 0) --p.stepsToRemoval;
      continue;
    }
    const glm::dvec3 from = p.body.state().position;
    const bool wasClosed = p.body.parachuteOpen() == 0;
    p.body.step(setup.wind, FixedStep::kStepSeconds);
    const glm::dvec3 to = p.body.state().position;
    if (wasClosed && p.body.parachuteOpen() > 0) report(GameEventKind::parachuteOpened, to, p.id);
    // The ground is asked only where what was left above it may be used up (1 microsecond a time on real
    // land).
    p.clearance -= kSteepestSlope * horizontalDistance(from, to) + std::abs(to.y - from.y);
    if (p.clearance > 0) continue;
    p.clearance = clearanceAt(ground(), to);
    const auto contact = sweepContact(ground(), from, to, 0, clearanceAt(ground(), from), p.clearance);
    if (!contact) continue;
    p.body.land(contact->position);
    p.onWater = contact->water;
    p.stepsToRemoval = stepsOf(setup.game.landedPackageSeconds);
    report(GameEventKind::packageLanded, contact->position, p.id, 0, contact->water);
    judge(p);
  }
  std::erase_if(packages, [this](const FlyingPackage& p) {
    const bool gone = p.body.landed() && p.stepsToRemoval == 0;
    if (gone) report(GameEventKind::packageRemoved, p.body.state().position, p.id);
    return gone;
  });
}

void World::State::judge(const FlyingPackage& p) {
  if (!p.target) return;
  const glm::dvec3 position = p.body.state().position;
  const double distance = horizontalDistance(position, p.target->position);
  if (distance <= p.target->radius) {
    ++score;
    say(withMetres("On target, %.0f m from the centre", distance));
    report(GameEventKind::scored, position, p.id, distance);
    // A drop elsewhere that came down inside after all: this target is done.
    if (target && target->id == p.target->id)
      drawNextTarget(airplane ? airplane->body().position() : position);
  } else {
    ++misses;
    say(withMetres("Missed by %.0f m", distance - p.target->radius));
    report(GameEventKind::missed, position, p.id, distance);
  }
}

void World::State::drawNextTarget(const glm::dvec3& around) {
  target.reset();
  stepsToTargetRetry = kTargetRetrySteps;
  if (const auto position = drawTarget(ground(), around, setup.game, random)) {
    target = Target{++targetsDrawn, *position, setup.game.targetRadius};
    report(GameEventKind::targetDrawn, *position, target->id);
  } else {
    say("No land for a target in reach");
  }
}

void World::State::say(std::string text) {
  messages.push_back({std::move(text), std::max<std::uint64_t>(stepsOf(setup.game.messageSeconds), 1)});
}

void World::State::report(GameEventKind kind, const glm::dvec3& position, std::uint32_t id,
                          double missDistance, bool onWater) {
  if (events.size() == kMostEvents) events.erase(events.begin());
  events.push_back({kind, steps, position, id, missDistance, onWater});
}

void World::State::fill(Snapshot& out) const {
  out.stepCount = steps;
  out.simulatedSeconds = secondsOf(steps);
  out.wind = setup.wind;
  out.aircraft.present = airplane.has_value();
  if (airplane) {
    AircraftSnapshot& a = out.aircraft;
    const flight::BodyState& s = airplane->body().state();
    const flight::Airflow flow = flight::airflowOf(airplane->settings(), setup.wind, s);
    const flight::Attitude attitude = flight::attitudeOf(s.orientation);
    a.position = s.position;
    a.orientation = s.orientation;
    a.velocity = s.velocity;
    a.angularVelocityBody = s.angularVelocity;
    a.airspeedMps = crashed ? 0 : flow.airspeed;
    a.throttle = crashed ? 0 : airplane->throttle();
    a.controls = controls;
    a.propellerAngleRad = propellerAngleRad;
    a.headingRad = attitude.headingRad;
    a.pitchRad = attitude.pitchRad;
    a.bankRad = attitude.bankRad;
    a.loadFactor = flow.loadFactor;
    a.heightAboveGround = clearance;
    a.groundHeight = s.position.y - clearance;
    a.stalled = flow.stalled && !crashed;
    a.crashed = crashed;
    a.secondsToRespawn = secondsOf(stepsToRespawn);
    a.spawnCount = spawnCount;
  }
  out.packages.clear();
  for (const FlyingPackage& p : packages) {
    const flight::BodyState& s = p.body.state();
    out.packages.push_back(
        {p.id, s.position, s.orientation, s.velocity, p.body.parachuteOpen(), p.body.landed(), p.onWater});
  }
  out.target = {};
  if (target) {
    out.target.present = true;
    out.target.id = target->id;
    out.target.position = target->position;
    out.target.radius = target->radius;
    if (airplane) {
      out.target.distance = horizontalDistance(target->position, airplane->body().position());
      out.target.bearingRad = bearingOf(target->position - airplane->body().position());
    }
  }
  out.predictedLanding = predictedLanding;
  out.dropZone =
      target && predictedLanding && horizontalDistance(*predictedLanding, target->position) <= target->radius;
  out.cooldownSeconds = secondsOf(stepsToDrop);
  out.score = score;
  out.drops = drops;
  out.misses = misses;
  out.messages.clear();
  for (const TimedMessage& message : messages)
    out.messages.push_back({message.text, secondsOf(message.stepsLeft)});
}

std::uint64_t World::State::hash() const {
  core::StateHasher h;
  h.add(steps), h.add(random.seed), h.add(random.counter);
  addTo(h, setup.wind);
  WorldSetup copy = setup;  // describe() wants something it could write to
  HashingVisitor settings(h);
  describe(settings, copy.airplane), describe(settings, copy.package), describe(settings, copy.game);
  if (airplane) {
    addTo(h, airplane->body().state());
    h.add(airplane->throttle()), h.add(clearance), h.add(propellerAngleRad);
    h.add(std::uint64_t{controls.drop}), h.add(std::uint64_t{controls.reset});
    h.add(std::uint64_t{crashed}), h.add(stepsToRespawn), h.add(std::uint64_t{spawnCount});
    for (const SafePlace& place : safePlaces) {
      h.add(place.step), addTo(h, place.position), h.add(place.headingRad);
    }
  }
  const auto addTarget = [&](const std::optional<Target>& t) {
    h.add(std::uint64_t{t ? t->id : 0});
    if (t) addTo(h, t->position), h.add(t->radius);
  };
  addTarget(target);
  h.add(stepsToTargetRetry), h.add(stepsToDrop);
  h.add(static_cast<std::uint64_t>(score)), h.add(static_cast<std::uint64_t>(drops));
  h.add(static_cast<std::uint64_t>(misses));
  for (const FlyingPackage& p : packages) {
    h.add(std::uint64_t{p.id}), addTo(h, p.body.state()), h.add(p.body.age());
    h.add(std::uint64_t{p.body.landed()}), h.add(p.clearance), h.add(p.stepsToRemoval);
    addTarget(p.target);
  }
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
}

const Snapshot& World::now() const { return state_->now; }
const Snapshot& World::before() const { return state_->before; }

Snapshot World::interpolated(double alpha) const {
  const Snapshot& a = state_->before;
  Snapshot out = state_->now;
  const double t = std::isfinite(alpha) ? std::clamp(alpha, 0.0, 1.0) : 1.0;
  const auto between = [t](double p, double q) { return p + (q - p) * t; };
  const auto mixed = [t](const glm::dvec3& p, const glm::dvec3& q) { return p + (q - p) * t; };
  const auto turned = [t](const glm::dquat& p, const glm::dquat& q) {
    return glm::normalize(p * (1 - t) + (glm::dot(p, q) < 0 ? -q : q) * t);
  };
  out.simulatedSeconds = between(a.simulatedSeconds, out.simulatedSeconds);
  AircraftSnapshot& craft = out.aircraft;
  if (craft.present && a.aircraft.spawnCount == craft.spawnCount) {
    craft.position = mixed(a.aircraft.position, craft.position);
    craft.orientation = turned(a.aircraft.orientation, craft.orientation);
    craft.velocity = mixed(a.aircraft.velocity, craft.velocity);
    craft.throttle = between(a.aircraft.throttle, craft.throttle);
    double turn = craft.propellerAngleRad - a.aircraft.propellerAngleRad;
    if (turn < 0) turn += dmath::kTwoPi;
    craft.propellerAngleRad = a.aircraft.propellerAngleRad + turn * t;
    if (craft.propellerAngleRad >= dmath::kTwoPi) craft.propellerAngleRad -= dmath::kTwoPi;
  }
  for (PackageSnapshot& p : out.packages) {
    const auto old =
        std::find_if(a.packages.begin(), a.packages.end(), [&](const auto& o) { return o.id == p.id; });
    if (old == a.packages.end()) continue;
    p.position = mixed(old->position, p.position);
    p.orientation = turned(old->orientation, p.orientation);
    p.parachuteOpen = between(old->parachuteOpen, p.parachuteOpen);
  }
  return out;
}

std::vector<GameEvent> World::takeEvents() { return std::exchange(state_->events, {}); }
std::uint64_t World::stateHash() const { return state_->hash(); }
std::uint64_t World::stepCount() const { return state_->steps; }

void World::apply(const flight::AirplaneSettings& settings) {
  if (state_->airplane) state_->airplane->apply(settings);
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

void World::placeAircraft(const StartPose& pose) {
  if (!state_->airplane) return;
  state_->place(pose);
  state_->predictedLanding = state_->predict();
  state_->fill(state_->now);
  state_->before = state_->now;
}

}  // namespace skydrop::game
