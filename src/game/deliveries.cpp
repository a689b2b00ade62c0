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
// More packages than this in the world at once are not possible (with the cool-down of 2 s: never reached).
constexpr std::size_t kMostPackages = 64;
// Without land in reach a target is searched again so often.
constexpr std::uint64_t kTargetRetrySteps = 1200;
// With weather a package asks for the wind so often: each .8 m under its parachute, 6 m in free fall.
constexpr std::uint64_t kWindSteps = 12;

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
    target_ = Target{++targetsDrawn_, *position, setup_->game.targetRadius};
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
                       {0, 1, 0}});
  stepsToDrop_ = stepsOf(setup_->game.dropCooldown);
  eventLog_->report(GameEventKind::drop, release.position, id);
  const auto landing = target_ ? predictLanding(aircraft) : std::nullopt;
  if (landing && isInTarget(*landing)) drawNextTarget(aircraft.position);
}

std::optional<glm::dvec3> Deliveries::predictLanding(const flight::BodyState& aircraft) const {
  const auto surface = [this](const glm::dvec2& xz) { return surfaceAt(*setup_->ground, xz).height; };
  const auto wind = [this](const glm::dvec3& position, double height) {
    return air_->meanWind(position, height);
  };
  const flight::PointState release = releaseState(aircraft);
  const auto landing =
      setup_->weather ? flight::predictLanding(setup_->package, release, flight::WindField(wind), surface)
                      : flight::predictLanding(setup_->package, release, setup_->wind, surface);
  if (!landing) return {};
  return landing->position;
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
  p.onWater = contact->water;
  if (!contact->water) {
    const glm::dvec2 slope = setup_->ground->sample({contact->position.x, contact->position.z}).gradient;
    p.groundNormal = glm::dvec3(-slope.x, 1, -slope.y) / std::sqrt(1 + slope.x * slope.x + slope.y * slope.y);
  }
  p.stepsToRemoval = stepsOf(setup_->game.landedPackageSeconds);
  eventLog_->report(GameEventKind::packageLanded, contact->position, p.id, 0, contact->water);
  judge(p, aircraft);
}

void Deliveries::judge(const FlyingPackage& p, const std::optional<glm::dvec3>& aircraft) {
  if (!p.target) return;
  const glm::dvec3 position = p.body.state().position;
  const double distance = horizontalDistance(position, p.target->position);
  if (distance <= p.target->radius) {
    ++score_;
    eventLog_->say(withMetres("On target, %.0f m from the centre", distance), setup_->game.messageSeconds);
    eventLog_->report(GameEventKind::scored, position, p.id, distance);
    // A drop elsewhere that came down inside after all: this target is done.
    if (target_ && target_->id == p.target->id) drawNextTarget(aircraft.value_or(position));
  } else {
    ++misses_;
    eventLog_->say(withMetres("Missed by %.0f m", distance - p.target->radius), setup_->game.messageSeconds);
    eventLog_->report(GameEventKind::missed, position, p.id, distance);
  }
}

void Deliveries::fill(Snapshot& out, const std::optional<glm::dvec3>& aircraft) const {
  out.packages.clear();
  for (const FlyingPackage& p : packages_) {
    const flight::BodyState& s = p.body.state();
    out.packages.push_back({p.id, s.position, s.orientation, s.velocity, p.body.parachuteOpen(),
                            p.body.landed(), p.onWater, p.groundNormal});
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
