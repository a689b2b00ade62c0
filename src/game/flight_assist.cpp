#include "skydrop/game/flight_assist.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "game/stick.h"
#include "skydrop/core/deterministic_math.h"
#include "skydrop/core/guards.h"
#include "skydrop/flight/environment.h"
#include "skydrop/game/contact.h"
#include "skydrop/terrain/height_source.h"

namespace skydrop::game {
namespace {

namespace dmath = core::dmath;

// A turn has ended with the wings this level and the roll this slow.
constexpr double kLevelRad = 0.035, kStillRadPerS = 0.05;
// Held below the limit, for what a gust and the feedback add.
constexpr double kBankMarginRad = 0.035;
// A height is won back over so many seconds, by a path no steeper than this.
constexpr double kHoldSeconds = 4, kSteepestHold = 0.12;
// Pull for each part of the weight that a bank adds to what the wing carries.
constexpr double kBankLift = 0.21;
// Slower than this a turn takes more thrust, m/s.
constexpr double kSlow = 62;
// The path is followed in steps of at least so many seconds.
constexpr double kLookSeconds = 0.1;
// As steep as the shipped land is at most: what is left above it cannot be used up sooner.
constexpr double kSlopeAhead = 4;

}  // namespace

void describe(core::SettingsVisitor& v, AssistSettings& s) {
  v.flag("turns", s.turns,
         {.help = "Turns keep the height, and the bank stays below a limit. Off is for experts.",
          .aliases = "assisted, beginner, expert, easy, stability, hold altitude"});
  v.number("maxBankDeg", s.maxBankDeg,
           {.unit = "deg",
            .min = 10,
            .max = 60,
            .help = "Steepest bank of assisted turns: more turns tighter.",
            .aliases = "roll limit"});
  v.flag("terrainWarning", s.terrainWarning,
         {.help = "Warns of land or sea ahead on the path that is flown: PULL UP.",
          .aliases = "GPWS, TAWS, ground proximity, pull up"});
  v.number("warningSeconds", s.warningSeconds,
           {.unit = "s",
            .min = 1,
            .max = 20,
            .help = "So long before it would meet the ground the warning begins: more warns earlier.",
            .slider = core::Range{2, 12},
            .aliases = "GPWS, TAWS, ground proximity"});
}

Controls FlightAssist::decide(const Snapshot& now, const Controls& player, const AssistSettings& settings) {
  const AircraftSnapshot& craft = now.aircraft;
  const bool flies = craft.present && !craft.crashed && craft.gear.wheelsDown == 0 && !craft.gear.swims;
  if (!settings.turns || !flies || player.reset) {
    turning_ = false;
    heldM_.reset();
    return player;
  }
  if (player.roll != 0) turning_ = true;
  if (!turning_) return player;

  Controls out = player;
  const double most = std::max(settings.maxBankDeg * dmath::kRadPerDeg - kBankMarginRad,
                               settings.maxBankDeg * dmath::kRadPerDeg / 2);
  const double wanted = std::clamp(player.roll, -1.0, 1.0) * most;
  out.roll = rollTo(craft, wanted);
  if (player.roll == 0 && std::abs(craft.bankRad) < kLevelRad &&
      std::abs(craft.angularVelocityBody.z) < kStillRadPerS) {
    turning_ = false;
    heldM_.reset();
    return player;
  }
  if (player.pitch != 0) {
    heldM_.reset();
    return out;
  }
  if (!heldM_) heldM_ = craft.position.y;
  const double level = std::sqrt(craft.velocity.x * craft.velocity.x + craft.velocity.z * craft.velocity.z);
  const double climb = std::clamp((*heldM_ - craft.position.y) / (kHoldSeconds * std::max(level, 20.0)),
                                  -kSteepestHold, kSteepestHold);
  const double bankLift = kBankLift * (1 / std::max(dmath::cos(craft.bankRad), 0.5) - 1);
  out.pitch = std::clamp(pitchTo(craft, climb, 2) + bankLift, -1.0, 1.0);
  if (player.thrust == 0 && player.brake == 0 && craft.airspeedMps < kSlow)
    out.thrust = std::min((kSlow - craft.airspeedMps) / 4, 1.0);
  return out;
}

std::optional<double> secondsToGround(const terrain::HeightSource& ground, const AircraftSnapshot& craft,
                                      double horizonSeconds) {
  if (!craft.present || craft.crashed || craft.gear.wheelsDown > 0 || craft.gear.swims) return {};
  if (!core::isFinite(craft.position) || !core::isFinite(craft.velocity) || !std::isfinite(craft.bankRad) ||
      !(horizonSeconds > 0))
    return {};
  const glm::dvec3& v = craft.velocity;
  const double level = std::sqrt(v.x * v.x + v.z * v.z), speed = std::sqrt(level * level + v.y * v.y);
  const double bank = std::clamp(craft.bankRad, -1.2, 1.2);
  const double turnRate = level > 1 ? flight::kGravity * dmath::tan(bank) / level : 0;
  glm::dvec3 at = craft.position, velocity = v;
  const double horizon = std::min(horizonSeconds, 60.0);
  for (double t = 0; t <= horizon;) {
    const double clearance = clearanceAt(ground, at);
    if (!std::isfinite(clearance)) return {};
    if (clearance <= 0) {
      if (craft.gear.present) {
        const Surface surface = surfaceAt(ground, {at.x, at.z});
        const glm::dvec2 slope = surface.water ? glm::dvec2(0) : ground.sample({at.x, at.z}).gradient;
        const double sink = -(velocity.y - slope.x * velocity.x - slope.y * velocity.z) /
                            std::sqrt(1 + slope.x * slope.x + slope.y * slope.y);
        if (sink < kGentleSink) return {};
      }
      return t;
    }
    const double dt = std::max(kLookSeconds, clearance / (kSlopeAhead * level + std::abs(v.y) + 1));
    const double angle = turnRate * dt, c = dmath::cos(angle), s = dmath::sin(angle);
    // A compass turn to the right: from north (-z) to east (+x).
    const glm::dvec3 turned(velocity.x * c - velocity.z * s, velocity.y, velocity.x * s + velocity.z * c);
    at += 0.5 * dt * (velocity + turned);
    velocity = turned;
    t += dt;
    if (!(speed > 0)) return {};
  }
  return {};
}

}  // namespace skydrop::game
