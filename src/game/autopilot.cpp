#include "skydrop/game/autopilot.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>

#include "game/angle.h"
#include "game/landing_pilot.h"
#include "game/stick.h"
#include "skydrop/core/deterministic_math.h"
#include "skydrop/core/fixed_step.h"
#include "skydrop/flight/environment.h"
#include "skydrop/game/contact.h"
#include "skydrop/terrain/height_source.h"
#include "skydrop/terrain/strips.h"

namespace skydrop::game {
namespace {

namespace dmath = core::dmath;

// The ground ahead is looked at so often, so far apart along the way and so far to both sides of it.
constexpr std::uint64_t kPlanSteps = 60;
constexpr double kLookSeconds = 1;
constexpr double kLookAsideMetres = 80;
// Heights are to be reached this far before the ground that needs them, m; it also softens small errors.
constexpr double kReachMetres = 200;
// Steepest climb and descent that it asks for, radians.
constexpr double kSteepestClimb = 0.45, kSteepestDescent = 0.17;
// Below this speed it does not climb, m/s: a margin over the stall in a turn.
constexpr double kClimbSpeed = 50;
// A target nearer than this, in diameters of a full turn, and not ahead is left behind first.
constexpr double kTurnDiameters = 1.2, kReturnDiameters = 2.0;
constexpr double kAheadRad = 0.6;
// It looks so far for a strip to land on, m.
constexpr double kFarthestStrip = 60000;
// It flies so far over the tops of trees at least, m.
constexpr double kOverTreesMetres = 20;
// Full deflections a second.
constexpr double kStickPerSecond = 4;

// Its hand on the stick is no faster than a pilot's.
Controls eased(const Controls& from, Controls to) {
  const double reach = kStickPerSecond * core::FixedStep::kStepSeconds;
  to.roll = from.roll + std::clamp(to.roll - from.roll, -reach, reach);
  to.pitch = from.pitch + std::clamp(to.pitch - from.pitch, -reach, reach);
  return to;
}

}  // namespace

void describe(core::SettingsVisitor& v, AutopilotSettings& s) {
  v.number("clearance", s.clearance,
           {.unit = "m",
            .min = 30,
            .max = 2000,
            .help = "Height above the highest ground ahead: more is safer.",
            .slider = core::Range{30, 1000},
            .aliases = "altitude, terrain avoidance"});
  v.number("lookAheadSeconds", s.lookAheadSeconds,
           {.unit = "s",
            .min = 5,
            .max = 120,
            .help = "Time of flight in which the ground counts: more climbs earlier.",
            .aliases = "terrain avoidance"});
  v.number("maxBankDeg", s.maxBankDeg,
           {.unit = "deg",
            .min = 10,
            .max = 70,
            .help = "Steepest bank in turns: more turns tighter.",
            .aliases = "roll angle"});
  v.number("dropMargin", s.dropMargin,
           {.unit = "1",
            .min = 0.05,
            .max = 1,
            .help = "Drops when the predicted miss is below this share of the radius: less drops nearer to "
                    "the centre.",
            .aliases = "aim"});
  v.integer("landEvery", s.landEvery,
            {.unit = "packages",
             .min = 0,
             .max = 100,
             .help = "Lands on the nearest strip after so many packages and takes off again; 0 never lands.",
             .slider = core::Range{0, 10},
             .aliases = "landing, strip"});
}

Autopilot::Autopilot(std::shared_ptr<const terrain::HeightSource> ground, const AutopilotSettings& settings)
    : ground_(std::move(ground)), settings_(settings), landing_(std::make_unique<LandingPilot>()) {}

// Where to fly: to the target, and in wind to where a package that is dropped on the way drifts onto it. What
// it drifts is known for the ground below; it is scaled to the height above the target.
Autopilot::Aim Autopilot::aimOf(const Snapshot& now) {
  const glm::dvec3& wind = now.wind;
  const Aim target{now.target.bearingRad, now.target.distance, now.target.present};
  if (!target.present) return target;
  if (!now.predictedLanding || (wind.x == 0 && wind.z == 0)) return target;
  const AircraftSnapshot& craft = now.aircraft;
  const glm::dvec2 path(craft.velocity.x, craft.velocity.z);
  const double speed2 = path.x * path.x + path.y * path.y;
  if (!(speed2 > 1)) return target;
  const glm::dvec2 fall(now.predictedLanding->x - craft.position.x,
                        now.predictedLanding->z - craft.position.z);
  const double height = std::max(craft.position.y - now.predictedLanding->y, 1.0);
  const double share = std::clamp((craft.position.y - now.target.position.y) / height, 0.2, 4.0);
  const glm::dvec2 aside = (fall - path * ((fall.x * path.x + fall.y * path.y) / speed2)) * share;
  const glm::dvec2 way =
      glm::dvec2(now.target.position.x - craft.position.x, now.target.position.z - craft.position.z) - aside;
  if (way.x == 0 && way.y == 0) return target;
  return {dmath::atan2(way.x, -way.y), std::sqrt(way.x * way.x + way.y * way.y), true};
}

Autopilot::~Autopilot() = default;
Autopilot::Autopilot(Autopilot&&) noexcept = default;

std::optional<Controls> Autopilot::handleGround(const Snapshot& now) {
  using Phase = LandingPilot::Phase;
  const AircraftSnapshot& craft = now.aircraft;
  if (!craft.gear.present || craft.gear.swims) {
    landing_->forget();
    return {};
  }
  const terrain::Strips* strips = ground_->strips();
  const glm::dvec2 here(craft.position.x, craft.position.z);
  const bool isInAir = landing_->phase() == Phase::away || landing_->phase() == Phase::approach;
  if (isInAir && craft.gear.wheelsDown > 0)
    landing_->beginTakeOff(strips ? strips->at(here) : std::nullopt, now);
  const bool wants =
      settings_.landEvery > 0 && (!now.target.present || now.drops - landedAtDrops_ >= settings_.landEvery);
  if (landing_->phase() == Phase::away && wants && strips) {
    const auto strip = strips->nearest(here, kFarthestStrip);
    if (strip && LandingPilot::isCalmEnough(*strip, now)) landing_->begin(*strip, now);
  }
  if (landing_->phase() == Phase::away) return {};
  if (landing_->phase() == Phase::approach && !landing_->entersFinal(now)) {
    const glm::dvec2 way = landing_->gate() - here;
    return flyTo(now, {dmath::atan2(way.x, -way.y), std::sqrt(way.x * way.x + way.y * way.y), true, true});
  }
  if (landing_->phase() == Phase::rollOut) landedAtDrops_ = now.drops;
  Controls out = landing_->decide(now);
  planned_ = goingAround_ = false;
  return eased(craft.controls, out);
}

Controls Autopilot::decide(const Snapshot& now) {
  const AircraftSnapshot& craft = now.aircraft;
  if (!craft.present || craft.crashed) {
    planned_ = goingAround_ = false;
    landing_->forget();
    return {};
  }
  if (const std::optional<Controls> onGround = handleGround(now)) return *onGround;
  Controls out = flyTo(now, aimOf(now));
  if (now.target.present && now.predictedLanding && now.cooldownSeconds <= 0 && !craft.controls.drop) {
    const glm::dvec3 miss = *now.predictedLanding - now.target.position;
    out.drop = std::sqrt(miss.x * miss.x + miss.z * miss.z) < settings_.dropMargin * now.target.radius;
  }
  return out;
}

Controls Autopilot::flyTo(const Snapshot& now, const Aim& aim) {
  Controls out;
  const AircraftSnapshot& craft = now.aircraft;
  const double speed = std::max(craft.airspeedMps, 20.0);
  const double track = dmath::atan2(craft.velocity.x, -craft.velocity.z);
  const double maxBank = settings_.maxBankDeg * dmath::kRadPerDeg;
  const double turnRate = flight::kGravity * dmath::tan(maxBank) / speed;  // rad/s in a full turn
  // Wind carries turns along, and it may come from behind.
  const double overGround = speed + std::sqrt(now.wind.x * now.wind.x + now.wind.z * now.wind.z);
  const double turnDiameter = 2 * overGround / turnRate;

  // Where to: the target, or away from it when it lies inside the turn; without one around in a wide circle.
  double turn = 0.25;
  if (aim.present) {
    const double distance = aim.distance;
    turn = wrappedAngle(aim.bearingRad - track);
    if (distance < kTurnDiameters * turnDiameter && std::abs(turn) > kAheadRad) goingAround_ = true;
    if (distance > kReturnDiameters * turnDiameter || std::abs(turn) < kAheadRad) goingAround_ = false;
    if (goingAround_) turn = 0;
  }

  // How steep: along the way that this turn will fly, the steepest path that any ground there asks for.
  if (!planned_ || now.stepCount >= plannedStep_ + kPlanSteps || now.stepCount < plannedStep_) {
    planned_ = true;
    plannedStep_ = now.stepCount;
    wantedSlope_ = -1;
    const double overTrees = obstacleHeight_ > 0 ? obstacleHeight_ + kOverTreesMetres : 0;
    const double clearance = std::max(settings_.clearance, overTrees);
    glm::dvec2 at{craft.position.x, craft.position.z};
    double heading = track, left = turn;
    const double farthest =
        aim.descendsThere ? std::max(aim.distance, kReachMetres) : std::numeric_limits<double>::infinity();
    for (double t = 0; t <= settings_.lookAheadSeconds && overGround * t <= farthest; t += kLookSeconds) {
      const glm::dvec2 ahead{dmath::sin(heading), -dmath::cos(heading)}, aside{-ahead.y, ahead.x};
      for (const double side : {-kLookAsideMetres, 0.0, kLookAsideMetres}) {
        const double height = surfaceAt(*ground_, at + aside * side).height;
        const double missing = height + clearance - craft.position.y;
        // Behind the margin a slope is a slope; inside it height is missing now.
        const double way = missing > 0 ? std::max(overGround * t - kReachMetres, kReachMetres)
                                       : overGround * t + kReachMetres;
        wantedSlope_ = std::max(wantedSlope_, missing / way);
      }
      at += ahead * (overGround * kLookSeconds);
      const double change = std::clamp(left, -turnRate * kLookSeconds, turnRate * kLookSeconds);
      heading += change;
      left -= change;
    }
  }

  // Bank into the turn; feedback on the bank, and what the stabiliser takes away.
  const double wantedBank = std::clamp(1.5 * turn, -maxBank, maxBank);
  out.roll = rollTo(craft, wantedBank);

  // Climb or sink along it. The path is held by feedback on the path, and by what the stabiliser takes away.
  double climb = std::clamp(wantedSlope_, -kSteepestDescent, kSteepestClimb);
  if (speed < kClimbSpeed) climb = std::min(climb, 0.0);
  out.pitch = std::clamp(pitchTo(craft, climb, 2), -1.0, 1.0);
  out = eased(craft.controls, out);

  // Speed: full thrust to climb, brake when a descent runs away.
  out.thrust = climb > 0.05 || speed < kClimbSpeed ? 1 : 0;
  out.brake = speed > 90 && climb < 0.02 ? 1 : 0;
  return out;
}

}  // namespace skydrop::game
