#include "game/player_aircraft.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "game/state_digest.h"
#include "game/steps.h"
#include "skydrop/core/deterministic_math.h"
#include "skydrop/core/error.h"
#include "skydrop/core/guards.h"
#include "skydrop/flight/rotation.h"
#include "skydrop/terrain/places.h"
#include "skydrop/terrain/woods.h"

namespace skydrop::game {
namespace {

namespace dmath = core::dmath;
using core::FixedStep;

// Safe places are noted twice a second.
constexpr std::uint64_t kSafePlaceSteps = 60;
// A safe place is flown through upright and with speed: sines of bank and pitch, share of the cruise speed.
constexpr double kSafeSineBank = 0.87, kSafeSinePitch = 0.5, kSafeSpeedShare = 0.6;
// The respawn clears the ground of this many seconds of flight ahead, asked every 20 m.
constexpr double kRespawnAheadSeconds = 8, kRespawnAheadMetres = 20;
// The shaking that announces a stall, of that in it.
constexpr double kBuffetBeforeStall = 0.3;
// With a gear its points decide; the middle of the aircraft is only kept from going through a mountain, m.
constexpr double kMiddleMargin = 0.3;
// On its wheels: the middle's height over the ground, m, and the nose's over the horizon, radians
// (docs/ground-handling.md: as it settles).
constexpr double kRestHeight = 1.2893, kRestPitchRad = 0.2397;
// A wreck that met the ground faster than this lies where it struck, m/s.
constexpr double kShatterSpeed = 12;
// What of the aircraft meets trees: its middle, places along its wings and its tail, body axes, m; and how
// near they must be, m. A step moves it by less than that at any speed that it reaches.
constexpr std::array<glm::dvec3, 6> kTouchPoints = {glm::dvec3{0, 0, 0}, {-2.4, 0.3, 0}, {2.4, 0.3, 0},
                                                    {-4.6, 0.4, 0},      {4.6, 0.4, 0},  {0, 0.3, 3.5}};
constexpr double kTouchReach = 1.1;
// The propeller turns from 8 to 40 times a second between idle and full.
constexpr double kIdleTurnsPerS = 8, kThrottleTurnsPerS = 32;

}  // namespace

PlayerAircraft::PlayerAircraft(const WorldSetup& setup, FlownAir& air, EventLog& eventLog)
    : setup_(&setup), air_(&air), eventLog_(&eventLog), airplane_(setup.airplane, {}) {
  if (setup.gear) ground_.emplace(*setup.gear);
  place(setup.start, 0);
}

void PlayerAircraft::place(const StartPose& pose, std::uint64_t step) {
  for (const double value : {pose.headingDeg, pose.pitchDeg, pose.bankDeg, pose.speed}) {
    if (!std::isfinite(value)) throw core::RangeError("world: the start pose is not finite");
  }
  if (!core::isFinite(pose.position)) throw core::RangeError("world: the start position is not finite");
  if (pose.onWheels && ground_) return putOnWheels(pose, step);
  glm::dvec3 position = pose.position;
  const double surface = surfaceAt(*setup_->ground, {position.x, position.z}).height;
  if (pose.aboveGround) position.y += surface;
  if (position.y - surface <= setup_->game.contactHeight) {  // a pose inside the ground
    position.y = surface + std::max(setup_->game.safeHeight, setup_->game.contactHeight + 1);
    core::countGuard(core::Guard::respawnRaised);
  }
  put(position, pose.headingDeg * dmath::kRadPerDeg, pose.pitchDeg * dmath::kRadPerDeg,
      pose.bankDeg * dmath::kRadPerDeg, pose.speed, step);
}

void PlayerAircraft::putOnWheels(const StartPose& pose, std::uint64_t step) {
  const glm::dvec2 xz(pose.position.x, pose.position.z);
  const terrain::HeightSample land = setup_->ground->sample(xz);
  const double heading = pose.headingDeg * dmath::kRadPerDeg;
  const glm::dvec2 ahead(dmath::sin(heading), -dmath::cos(heading));
  const double rise = land.gradient.x * ahead.x + land.gradient.y * ahead.y;
  const double aside = land.gradient.y * ahead.x - land.gradient.x * ahead.y;
  const glm::dvec3 position(xz.x, std::max(land.height, 0.0) + kRestHeight, xz.y);
  put(position, heading, kRestPitchRad + dmath::atan2(rise, 1), -dmath::atan2(aside, 1), 0, step);
  flight::BodyState rest = body();
  rest.velocity = glm::dvec3(0);
  airplane_.place(rest);
  airplane_.setThrottle(0);
  ground_->start(true);
}

void PlayerAircraft::put(const glm::dvec3& position, double headingRad, double pitchRad, double bankRad,
                         double speed, std::uint64_t step) {
  flight::BodyState state;
  state.position = position;
  state.orientation = flight::orientationOf({headingRad, pitchRad, bankRad});
  clearance_ = clearanceAt(*setup_->ground, position);
  air_->meet(position, position.y - clearance_, step);
  state.velocity =
      air_->meanWind(position, position.y - clearance_) + state.orientation * glm::dvec3(0, 0, -speed);
  airplane_.place(state);
  trail_.place(state.orientation);
  crashed_ = slides_ = false;
  stepsToRespawn_ = 0;
  ++spawnCount_;
  safePlaces_.startFrom({step, position, headingRad});
  if (ground_) ground_->start(false);
  hasFlown_ = false;
  endReason_.clear();
}

void PlayerAircraft::respawn(std::uint64_t step) {
  if (setup_->start.onWheels && ground_ && !hasFlown_) {
    place(setup_->start, step);
    eventLog_->report(GameEventKind::respawned, body().position);
    return;
  }
  SafePlace place = safePlaces_.newestBefore(
      step, stepsOf(setup_->game.respawnBackSeconds) + stepsOf(setup_->game.crashSeconds));
  const double speed = setup_->airplane.cruiseSpeed;
  const glm::dvec2 ahead{dmath::sin(place.headingRad), -dmath::cos(place.headingRad)};
  double needed = -1e300;
  for (double way = 0; way <= speed * kRespawnAheadSeconds; way += kRespawnAheadMetres) {
    const glm::dvec2 at = glm::dvec2(place.position.x, place.position.z) + ahead * way;
    needed = std::max(needed, surfaceAt(*setup_->ground, at).height + setup_->game.safeHeight);
  }
  if (place.position.y < needed) {
    place.position.y = needed;
    core::countGuard(core::Guard::respawnRaised);
  }
  put(place.position, place.headingRad, 0, 0, speed, step);
  eventLog_->report(GameEventKind::respawned, place.position);
}

void PlayerAircraft::clearGround(std::uint64_t step) {
  glm::dvec3 position = body().position;
  clearance_ = clearanceAt(*setup_->ground, position);
  const double heading = flight::attitudeOf(body().orientation).headingRad;
  safePlaces_.startFrom({step, position, heading});
  if (clearance_ >= setup_->game.safeHeight && !crashed_) return;
  position.y += std::max(0.0, setup_->game.safeHeight - clearance_);
  put(position, heading, 0, 0, setup_->airplane.cruiseSpeed, step);
  core::countGuard(core::Guard::respawnRaised);
}

void PlayerAircraft::applyGear(std::uint64_t step) {
  if (setup_->gear && ground_) return ground_->apply(*setup_->gear);
  if (setup_->gear) {
    ground_.emplace(*setup_->gear);
    return;
  }
  const bool wasDown = ground_ && (ground_->onWheels() || ground_->swims());
  ground_.reset();
  if (wasDown) clearGround(step);
}

void PlayerAircraft::meetAir(std::uint64_t step) {
  air_->meet(body().position, body().position.y - clearance_, step);
}

void PlayerAircraft::advance(const Controls& controls, std::uint64_t step) {
  lastControls_ = std::exchange(controls_, controls);
  if (controls_.reset && !lastControls_.reset) {
    place(setup_->start, step);
    eventLog_->report(GameEventKind::reset, body().position);
  } else {
    move(step);
  }
}

void PlayerAircraft::move(std::uint64_t step) {
  if (crashed_) {
    if (ground_ && slides_) {
      // Whatever else breaks of a wreck is no news.
      ground_->step(airplane_, {}, air_->now(), *setup_->ground, *eventLog_);
      clearance_ = clearanceAt(*setup_->ground, body().position);
    }
    trail_.follow(body().orientation);
    if (--stepsToRespawn_ == 0) respawn(step);
    return;
  }
  fly(step);
  if (!ground_ || !ground_->swims() || crashed_) return;
  if (ground_->swimSteps() > stepsOf(setup_->gear->floatSeconds)) {
    respawn(step);
  }
}

void PlayerAircraft::turnPropeller() {
  propellerAngleRad_ +=
      dmath::kTwoPi * (kIdleTurnsPerS + kThrottleTurnsPerS * airplane_.throttle()) * FixedStep::kStepSeconds;
  if (propellerAngleRad_ >= dmath::kTwoPi) propellerAngleRad_ -= dmath::kTwoPi;
}

void PlayerAircraft::fly(std::uint64_t step) {
  const glm::dvec3 from = body().position;
  std::optional<Damage> damage;
  if (ground_ && ground_->isNear(clearance_)) {
    damage = ground_->step(airplane_, controls_, air_->now(), *setup_->ground, *eventLog_);
  } else {
    flight::AirplaneInput levers{.thrust = controls_.thrust,
                                 .brake = controls_.brake,
                                 .pitch = controls_.pitch,
                                 .roll = controls_.roll,
                                 .yaw = controls_.yaw};
    if (ground_) {
      levers = ground_->levers(controls_);
      ground_->leave(controls_, from, *eventLog_);
    }
    airplane_.step(levers, air_->now(), FixedStep::kStepSeconds);
  }
  if (!ground_ || !ground_->swims()) turnPropeller();
  trail_.follow(body().orientation);

  const glm::dvec3 to = body().position;
  const double clearanceBefore = std::exchange(clearance_, clearanceAt(*setup_->ground, to));
  if (damage) return endFlight(*damage);
  if (ground_ && ground_->swims()) return;
  const double margin = ground_ ? kMiddleMargin : setup_->game.contactHeight;
  if (const auto contact = sweepContact(*setup_->ground, from, to, margin, clearanceBefore, clearance_)) {
    crash(*contact, contact->water ? "Ditched in the sea" : "Crashed into the ground");
  } else if (const char* obstacle = touchedObstacle()) {
    crash({1, to, false}, obstacle);
    if (ground_) ground_->wreck(false);
  } else if (step % kSafePlaceSteps == 0) {
    noteSafePlace(step);
  }
}

const char* PlayerAircraft::touchedObstacle() const {
  if (!setup_->woods && !setup_->places) return nullptr;
  std::array<glm::dvec3, kTouchPoints.size()> points;
  std::ranges::transform(kTouchPoints, points.begin(), [&](const glm::dvec3& ofBody) {
    return body().position + body().orientation * ofBody;
  });
  if (setup_->woods && setup_->woods->touching(points, kTouchReach)) return "Flew into a tree";
  if (setup_->places && setup_->places->touching(points, kTouchReach)) return "Flew into a house";
  return nullptr;
}

void PlayerAircraft::noteSafePlace(std::uint64_t step) {
  const flight::BodyState& s = body();
  const glm::dvec3 forward = s.orientation * glm::dvec3(0, 0, -1),
                   right = s.orientation * glm::dvec3(1, 0, 0);
  const glm::dvec3 up = s.orientation * glm::dvec3(0, 1, 0);
  const bool upright = up.y > 0 && std::abs(right.y) < kSafeSineBank && std::abs(forward.y) < kSafeSinePitch;
  const bool fast =
      glm::length(s.velocity - air_->now().wind) > kSafeSpeedShare * setup_->airplane.cruiseSpeed;
  if (!upright || !fast || clearance_ < setup_->game.safeHeight) return;
  safePlaces_.note({step, s.position, flight::attitudeOf(s.orientation).headingRad});
  hasFlown_ = true;
}

void PlayerAircraft::crash(const Contact& contact, std::string reason) {
  flight::BodyState rest = body();
  rest.position = contact.position;
  rest.velocity = rest.angularVelocity = glm::dvec3(0);
  airplane_.place(rest);
  clearance_ = clearanceAt(*setup_->ground, contact.position);
  crashed_ = true;
  slides_ = false;
  stepsToRespawn_ = std::max<std::uint64_t>(stepsOf(setup_->game.crashSeconds), 1);
  endReason_ = std::move(reason);
  eventLog_->say(endReason_, setup_->game.messageSeconds);
  eventLog_->report(GameEventKind::crashed, contact.position, 0, 0, contact.water);
}

void PlayerAircraft::endFlight(const Damage& damage) {
  const flight::BodyState& s = body();
  const glm::dvec3 normal = terrain::normalOf(
      damage.water ? terrain::HeightSample{} : setup_->ground->sample({s.position.x, s.position.z}));
  if (-glm::dot(s.velocity, normal) > kShatterSpeed) {
    crash({1, s.position, damage.water}, damage.reason);
  } else {
    crashed_ = slides_ = true;
    stepsToRespawn_ = std::max<std::uint64_t>(stepsOf(setup_->game.crashSeconds), 1);
    eventLog_->report(GameEventKind::crashed, s.position, 0, 0, damage.water);
    eventLog_->say(damage.reason, setup_->game.messageSeconds);
  }
  ground_->wreck(damage.legs);
  endReason_ = damage.reason;
}

AircraftSnapshot PlayerAircraft::snapshot() const {
  AircraftSnapshot a;
  const flight::BodyState& s = body();
  const flight::Airflow flow =
      flight::airflowOf(airplane_.settings(), airplane_.separation(), air_->now(), s);
  const flight::Attitude attitude = flight::attitudeOf(s.orientation);
  a.present = true;
  a.position = s.position;
  a.orientation = s.orientation;
  a.velocity = s.velocity;
  a.angularVelocityBody = s.angularVelocity;
  a.airspeedMps = crashed_ ? 0 : flow.airspeed;
  a.throttle = crashed_ ? 0 : airplane_.throttle();
  a.controls = controls_;
  a.propellerAngleRad = propellerAngleRad_;
  a.headingRad = attitude.headingRad;
  a.pitchRad = attitude.pitchRad;
  a.bankRad = attitude.bankRad;
  a.trailingOrientation = trail_.orientation();
  a.angleOfAttackRad = flow.angleOfAttack;
  a.sideslipRad = flow.sideslip;
  a.loadFactor = flow.loadFactor;
  a.heightAboveGround = clearance_;
  a.groundHeight = s.position.y - clearance_;
  if (!crashed_ && !(ground_ && (ground_->onWheels() || ground_->swims()))) {
    const double warning = airplane_.settings().stallWarning;
    a.stalled = airplane_.separation() >= flight::kStalledSeparation;
    a.stallWarning = a.stalled || flow.stallShare >= warning;
    const double near = std::clamp((flow.stallShare - warning) / (1 - warning + 1e-9), 0.0, 1.0);
    a.buffet = std::max(kBuffetBeforeStall * near, airplane_.separation());
  }
  if (ground_) ground_->fill(a.gear, s, *setup_->ground);
  a.gear.endReason = endReason_;
  a.crashed = crashed_;
  a.secondsToRespawn = secondsOf(stepsToRespawn_);
  a.spawnCount = spawnCount_;
  return a;
}

void PlayerAircraft::addTo(core::StateHasher& h) const {
  game::addTo(h, body());
  h.add(airplane_.throttle()), h.add(airplane_.separation()), h.add(clearance_), h.add(propellerAngleRad_);
  h.add(std::uint64_t{controls_.drop}), h.add(std::uint64_t{controls_.reset});
  h.add(std::uint64_t{crashed_}), h.add(stepsToRespawn_), h.add(std::uint64_t{spawnCount_});
  safePlaces_.addTo(h);
  if (ground_) {  // a flight without keeps the digest that it had before there was any
    ground_->addTo(h);
    h.add(std::uint64_t{slides_}), h.add(std::uint64_t{hasFlown_});
  }
}

}  // namespace skydrop::game
