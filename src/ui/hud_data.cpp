#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "skydrop/ui/hud.h"

namespace skydrop::ui {
namespace {

constexpr std::size_t kMaxMessages = 3;
constexpr double kFadeSeconds = 0.5;
constexpr double kMinArrowSpeed = 0.5;  // m/s over the ground: below it the direction means nothing

double finiteOr0(double value) { return std::isfinite(value) ? value : 0; }

// The part of the period that has passed, [0, 1).
double phase(double seconds, double period) {
  const double turns = finiteOr0(seconds) / period;
  return turns - std::floor(turns);
}

NavigationBar makeNavigationBar(const game::Snapshot& snapshot) {
  NavigationBar bar;
  const game::AircraftSnapshot& aircraft = snapshot.aircraft;
  const glm::dvec2 velocity(finiteOr0(aircraft.velocity.x), finiteOr0(aircraft.velocity.z));
  const double speed = std::hypot(velocity.x, velocity.y);
  if (speed >= kMinArrowSpeed) bar.arrow = velocity * (std::min(speed / kNavigationSpeedMps, 1.0) / speed);
  if (snapshot.target.present) {
    const glm::dvec2 offset(finiteOr0(snapshot.target.position.x - aircraft.position.x),
                            finiteOr0(snapshot.target.position.z - aircraft.position.z));
    // Within the range the distance is to scale; beyond it the dot stays on the rim. Straight above the
    // target it is the centre: nothing is divided by the distance there.
    bar.dot = offset / std::max(std::hypot(offset.x, offset.y), kNavigationRangeM);
    bar.dotLit =
        phase(snapshot.simulatedSeconds, kBlinkPeriodSeconds) < kBlinkLitSeconds / kBlinkPeriodSeconds;
  }
  return bar;
}

// Compass degrees, [0, 360), from where a wind comes; 0 in a calm.
double windFromDeg(const glm::dvec3& wind) {
  if (wind.x == 0 && wind.z == 0) return 0;
  const double degrees = std::atan2(-wind.x, wind.z) * 180 / std::numbers::pi;
  return degrees < 0 ? degrees + 360 : degrees + 0.0;  // -0 has a sign that would show
}

std::optional<HudAir> makeHudAir(const game::AirSnapshot& air) {
  if (!air.present) return std::nullopt;
  const glm::dvec3 wind(finiteOr0(air.wind.x), 0, finiteOr0(air.wind.z));
  return HudAir{finiteOr0(air.indicatedMps),
                finiteOr0(air.groundMps),
                -finiteOr0(air.driftRad) * 180 / std::numbers::pi,
                std::hypot(wind.x, wind.z),
                windFromDeg(wind),
                std::clamp(finiteOr0(air.icing), 0.0, 1.0)};
}

// What the wheels do, in few words.
std::string groundNote(const game::AircraftSnapshot& aircraft) {
  const game::GearSnapshot& gear = aircraft.gear;
  if (!gear.present || aircraft.crashed) return "";
  if (gear.swims) return "AFLOAT";
  if (gear.wheelsDown == 0) return "";
  if (gear.brakes <= 0) return gear.onStrip ? "ON THE STRIP" : "ON WHEELS";
  return gear.groundSpeedMps < 0.5 ? "BRAKES HOLD" : "BRAKING";
}

}  // namespace

HudData makeHudData(const game::Snapshot& snapshot) {
  HudData data;
  const game::AircraftSnapshot& aircraft = snapshot.aircraft;
  data.aircraft = aircraft.present;
  data.score = snapshot.score;
  data.misses = snapshot.misses;
  data.points = snapshot.points;
  data.paused = snapshot.paused;
  data.autopilot = snapshot.autopilot;
  data.frozen = snapshot.frozen;
  const std::size_t first = snapshot.messages.size() - std::min(snapshot.messages.size(), kMaxMessages);
  for (std::size_t i = first; i < snapshot.messages.size(); ++i) {
    const game::Message& message = snapshot.messages[i];
    data.messages.push_back(
        {message.text, std::clamp(finiteOr0(message.secondsLeft) / kFadeSeconds, 0.0, 1.0)});
  }
  for (auto p = snapshot.packages.rbegin(); p != snapshot.packages.rend() && !data.package; ++p) {
    if (p->landed || !p->landing) continue;
    data.package = HudPackage{std::max(finiteOr0(p->landing->seconds), 0.0), {}, p->landing->hits};
    if (p->landing->missM) data.package->missM = std::max(finiteOr0(*p->landing->missM), 0.0);
  }
  if (!aircraft.present) return data;

  data.airspeedMps = finiteOr0(aircraft.airspeedMps);
  data.altitudeM = finiteOr0(aircraft.position.y);
  data.heightAboveGroundM = finiteOr0(aircraft.heightAboveGround);
  const double turns = finiteOr0(aircraft.headingRad) / (2 * std::numbers::pi);
  data.headingDeg = 360 * (turns - std::floor(turns));
  data.throttle = std::clamp(finiteOr0(aircraft.throttle), 0.0, 1.0);
  data.navigation = makeNavigationBar(snapshot);
  data.air = makeHudAir(snapshot.air);
  if (snapshot.target.present) data.targetDistanceM = finiteOr0(snapshot.target.distance);
  if (snapshot.dropZone && !aircraft.crashed) {
    const double angle = 2 * std::numbers::pi * phase(snapshot.simulatedSeconds, kPulsePeriodSeconds);
    data.dropPulse = 0.5 + 0.5 * std::cos(angle);
  }
  data.cooldownSeconds = std::max(finiteOr0(snapshot.cooldownSeconds), 0.0);
  const double hintLeft = kHintSeconds - finiteOr0(snapshot.simulatedSeconds);
  if (!snapshot.autopilot) data.hintOpacity = std::clamp(hintLeft / kFadeSeconds, 0.0, 1.0);
  data.stalled = aircraft.stalled && !aircraft.crashed;
  data.stallWarning = aircraft.stallWarning && !data.stalled && !aircraft.crashed;
  data.ground = groundNote(aircraft);
  data.pullUp = snapshot.pullUpSeconds.has_value() && !aircraft.crashed;
  if (aircraft.crashed) data.crashReason = aircraft.gear.endReason;
  if (aircraft.crashed) data.respawnSeconds = std::max(finiteOr0(aircraft.secondsToRespawn), 0.0);
  return data;
}

}  // namespace skydrop::ui
