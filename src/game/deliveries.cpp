#include "game/deliveries.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "game/state_digest.h"
#include "game/steps.h"
#include "game/targets.h"
#include "skydrop/core/deterministic_math.h"
#include "skydrop/core/fixed_step.h"
#include "skydrop/game/contact.h"

namespace skydrop::game {
namespace {

namespace dmath = core::dmath;
using core::FixedStep;

// The package leaves below the belly, m, body axes.
constexpr glm::dvec3 kBay{0, -1.2, 0};
// What came of a package shows so much longer than other messages, s: one has waited for it.
constexpr double kResultSeconds = 2;
// More packages than this in the world at once are not possible (with the cool-down of 2 s: never reached).
constexpr std::size_t kMostPackages = 64;
// Without land in reach a target is searched again so often.
constexpr std::uint64_t kTargetRetrySteps = 1200;
// With weather a package asks for the wind so often: each .8 m under its parachute, 6 m in free fall.
constexpr std::uint64_t kWindSteps = 12;
// The landing of a falling package is predicted again so often: for the view alone.
constexpr std::uint64_t kLandingSteps = 60;

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

flight::PointState releaseState(const flight::BodyState& aircraft) {
  return {aircraft.position + aircraft.orientation * kBay, aircraft.velocity};
}

}  // namespace

Deliveries::Deliveries(const WorldSetup& setup, const FlownAir& air, core::RandomStream& random,
                       EventLog& eventLog)
    : setup_(&setup), air_(&air), random_(&random), eventLog_(&eventLog) {}

void Deliveries::drawNextTarget(const glm::dvec3& around) {
  target_.reset();
  stepsToTargetRetry_ = kTargetRetrySteps;
  if (const auto position = drawTarget(*setup_->ground, around, setup_->game, *random_)) {
    target_ = Target{++targetsDrawn_, *position, setup_->game.targetRadius, eventLog_->step(),
                     horizontalDistance(*position, around)};
    eventLog_->report(GameEventKind::targetDrawn, *position, target_->id);
  } else {
    eventLog_->say("No land for a target in reach", setup_->game.messageSeconds);
  }
}

void Deliveries::coolDown() {
  if (stepsToDrop_ > 0) --stepsToDrop_;
}

void Deliveries::drop(const flight::BodyState& aircraft) {
  if (stepsToDrop_ > 0) return;
  if (packages_.size() >= kMostPackages) {
    eventLog_->say("Too many packages in the air", setup_->game.messageSeconds);
    return;
  }
  const flight::PointState release = releaseState(aircraft);
  flight::BodyState body = aircraft;
  body.position = release.position;
  const auto id = static_cast<std::uint32_t>(++drops_);
  packages_.push_back({id,
                       flight::Package(setup_->package, body),
                       target_,
                       clearanceAt(*setup_->ground, release.position),
                       glm::dvec3(0),
                       0,
                       0,
                       weather::Dryden(core::hashCombine(setup_->seed, id)),
                       0,
                       false,
                       {0, 1, 0},
                       {release, eventLog_->step()},
                       {},
                       0});
  follow(packages_.back());
  stepsToDrop_ = stepsOf(setup_->game.dropCooldown);
  eventLog_->report(GameEventKind::drop, release.position, id);
  const std::optional<PackageLanding>& falls = packages_.back().landing;
  eventLog_->say(falls ? withMetres("Package away: %.0f s to the ground", falls->seconds) : "Package away",
                 setup_->game.messageSeconds);
  const auto landing = target_ ? predictLanding(aircraft) : std::nullopt;
  if (landing && isInTarget(*landing)) drawNextTarget(aircraft.position);
}

std::optional<glm::dvec3> Deliveries::target() const {
  if (!target_) return {};
  return target_->position;
}

std::optional<glm::dvec3> Deliveries::predictLanding(const flight::BodyState& aircraft) const {
  const auto landing = landingOf(releaseState(aircraft), 0);
  if (!landing) return {};
  return landing->position;
}

std::optional<flight::Landing> Deliveries::landingOf(const flight::PointState& state, double age) const {
  const auto surface = [this](const glm::dvec2& xz) { return surfaceAt(*setup_->ground, xz).height; };
  const auto wind = [this](const glm::dvec3& position, double height) {
    return air_->meanWind(position, height);
  };
  return setup_->weather
             ? flight::predictLanding(setup_->package, state, flight::WindField(wind), surface, age)
             : flight::predictLanding(setup_->package, state, setup_->wind, surface, age);
}

void Deliveries::follow(FlyingPackage& p) const {
  p.stepsToPrediction = kLandingSteps;
  const flight::BodyState& s = p.body.state();
  const auto landing = landingOf({s.position, s.velocity}, p.body.age());
  p.landing.reset();
  if (!landing) return;
  p.landing = PackageLanding{landing->position, landing->seconds, {}, false};
  if (!p.target) return;
  p.landing->missM = horizontalDistance(landing->position, p.target->position);
  p.landing->hits = *p.landing->missM <= p.target->radius;
}

bool Deliveries::isInTarget(const glm::dvec3& landing) const {
  return target_ && horizontalDistance(landing, target_->position) <= target_->radius;
}

void Deliveries::step(const std::optional<glm::dvec3>& aircraft, std::uint64_t step) {
  for (FlyingPackage& package : packages_) {
    if (!package.body.landed()) {
      fall(package, aircraft, step);
    } else if (package.stepsToRemoval > 0) {
      --package.stepsToRemoval;
    }
  }
  std::erase_if(packages_, [this](const FlyingPackage& p) {
    const bool gone = p.body.landed() && p.stepsToRemoval == 0;
    if (gone) eventLog_->report(GameEventKind::packageRemoved, p.body.state().position, p.id);
    return gone;
  });
  if (setup_->hasTargets && !target_ && stepsToTargetRetry_-- == 0) {
    drawNextTarget(aircraft.value_or(glm::dvec3(0)));
  }
}

void Deliveries::fall(FlyingPackage& p, const std::optional<glm::dvec3>& aircraft, std::uint64_t step) {
  const glm::dvec3 from = p.body.state().position;
  const bool wasClosed = p.body.parachuteOpen() == 0;
  if (!setup_->weather) {
    p.wind = setup_->wind;
  } else if (p.stepsToWind == 0) {
    p.clearance = clearanceAt(*setup_->ground, from);
    p.wind = air_->windOnPackage(from, p.body.state().velocity, from.y - p.clearance, secondsOf(step),
                                 p.gusts, p.windsAsked++, kWindSteps * FixedStep::kStepSeconds);
    p.stepsToWind = kWindSteps;
  }
  if (p.stepsToWind > 0) --p.stepsToWind;
  p.body.step(p.wind, FixedStep::kStepSeconds);
  if (p.landing) p.landing->seconds = std::max(p.landing->seconds - FixedStep::kStepSeconds, 0.0);
  if (--p.stepsToPrediction == 0) follow(p);
  const glm::dvec3 to = p.body.state().position;
  if (wasClosed && p.body.parachuteOpen() > 0) eventLog_->report(GameEventKind::parachuteOpened, to, p.id);
  // The ground is asked only where what was left above it may be used up (1 microsecond a time on real land).
  p.clearance -= kSteepestSlope * horizontalDistance(from, to) + std::abs(to.y - from.y);
  if (p.clearance > 0) return;
  p.clearance = clearanceAt(*setup_->ground, to);
  const auto contact =
      sweepContact(*setup_->ground, from, to, 0, clearanceAt(*setup_->ground, from), p.clearance);
  if (!contact) return;
  p.body.land(contact->position);
  p.landing.reset();
  p.onWater = contact->water;
  if (!contact->water) {
    const glm::dvec2 slope = setup_->ground->sample({contact->position.x, contact->position.z}).gradient;
    p.groundNormal = glm::dvec3(-slope.x, 1, -slope.y) / std::sqrt(1 + slope.x * slope.x + slope.y * slope.y);
  }
  p.stepsToRemoval = stepsOf(setup_->game.landedPackageSeconds);
  eventLog_->report(GameEventKind::packageLanded, contact->position, p.id, 0, contact->water);
  judge(p, aircraft, step);
}

Delivery Deliveries::deliveryOf(const FlyingPackage& p, std::uint64_t step) const {
  const Target& target = *p.target;
  const glm::dvec3 landed = p.body.state().position;
  const auto level = [](const glm::dvec3& v) { return glm::dvec2(v.x, v.z); };
  Delivery d;
  d.package = p.id;
  d.target = target.id;
  d.step = step;
  d.onWater = p.onWater;
  d.distanceM = horizontalDistance(landed, target.position);
  d.radiusM = target.radius;
  d.hit = d.distanceM <= target.radius;
  d.seconds = secondsOf(step - std::min(step, target.drawnStep));
  d.fallSeconds = secondsOf(step - std::min(step, p.release.step));
  const glm::dvec2 path = level(p.release.state.velocity), miss = level(landed - target.position);
  const double speed = std::sqrt(path.x * path.x + path.y * path.y);
  if (speed > 0) {
    d.alongM = (miss.x * path.x + miss.y * path.y) / speed;
    d.acrossM = (miss.y * path.x - miss.x * path.y) / speed;
  }
  // Where it would have come down in still air: what is left of the miss is the wind's.
  const auto surface = [this](const glm::dvec2& xz) { return surfaceAt(*setup_->ground, xz).height; };
  glm::dvec2 stillMiss = miss;
  if (const auto still = flight::predictLanding(setup_->package, p.release.state, glm::dvec3(0), surface)) {
    stillMiss = level(still->position - target.position);
    d.windM = horizontalDistance(still->position, landed);
  }
  d.reason = missReason(path, miss, stillMiss, target.radius);
  if (d.hit)
    d.points = pointsOf(setup_->delivery, d.distanceM, target.radius, d.seconds,
                        target.wayM / setup_->airplane.cruiseSpeed);
  return d;
}

void Deliveries::judge(const FlyingPackage& p, const std::optional<glm::dvec3>& aircraft,
                       std::uint64_t step) {
  if (!p.target) return;
  const glm::dvec3 position = p.body.state().position;
  const Delivery delivery = deliveryOf(p, step);
  const double distance = delivery.distanceM;
  if (log_.size() == kMostDeliveries) log_.erase(log_.begin());
  log_.push_back(delivery);
  points_ += delivery.points;
  eventLog_->say(sentenceOf(delivery), std::max(setup_->game.messageSeconds, 0.5) + kResultSeconds);
  if (delivery.hit) {
    ++score_;
    eventLog_->report(GameEventKind::scored, position, p.id, distance);
    // A drop elsewhere that came down inside after all: this target is done.
    if (target_ && target_->id == p.target->id) drawNextTarget(aircraft.value_or(position));
  } else {
    ++misses_;
    eventLog_->report(GameEventKind::missed, position, p.id, distance);
  }
}

void Deliveries::fill(Snapshot& out, const std::optional<glm::dvec3>& aircraft) const {
  out.packages.clear();
  for (const FlyingPackage& p : packages_) {
    const flight::BodyState& s = p.body.state();
    out.packages.push_back({p.id, s.position, s.orientation, s.velocity, p.body.parachuteOpen(),
                            p.body.landed(), p.onWater, p.groundNormal, p.landing});
  }
  out.target = {};
  if (target_) {
    out.target.present = true;
    out.target.id = target_->id;
    out.target.position = target_->position;
    out.target.radius = target_->radius;
    if (aircraft) {
      out.target.distance = horizontalDistance(target_->position, *aircraft);
      out.target.bearingRad = bearingOf(target_->position - *aircraft);
    }
  }
  out.cooldownSeconds = secondsOf(stepsToDrop_);
  out.score = score_;
  out.drops = drops_;
  out.misses = misses_;
  out.points = points_;
}

void Deliveries::addTo(core::StateHasher& h, const std::optional<Target>& t) {
  h.add(std::uint64_t{t ? t->id : 0});
  if (t) game::addTo(h, t->position), h.add(t->radius);
}

void Deliveries::addTo(core::StateHasher& h) const {
  addTo(h, target_);
  h.add(stepsToTargetRetry_), h.add(stepsToDrop_);
  h.add(static_cast<std::uint64_t>(score_)), h.add(static_cast<std::uint64_t>(drops_));
  h.add(static_cast<std::uint64_t>(misses_));
  for (const FlyingPackage& p : packages_) {
    h.add(std::uint64_t{p.id}), game::addTo(h, p.body.state()), h.add(p.body.age());
    h.add(std::uint64_t{p.body.landed()}), h.add(p.clearance), h.add(p.stepsToRemoval);
    if (setup_->weather) {
      game::addTo(h, p.wind), h.add(p.stepsToWind), h.add(p.windsAsked);
      for (int i = 0; i < weather::Dryden::kStates; ++i) h.add(p.gusts.states()[i]);
    }
    addTo(h, p.target);
  }
}

}  // namespace skydrop::game
