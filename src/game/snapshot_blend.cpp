#include "game/snapshot_blend.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "skydrop/core/deterministic_math.h"

namespace skydrop::game {

namespace dmath = core::dmath;

Snapshot blended(const Snapshot& a, const Snapshot& now, double share) {
  Snapshot out = now;
  const double t = std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 1.0;
  const auto between = [t](double p, double q) { return p + (q - p) * t; };
  const auto mixed = [t](const glm::dvec3& p, const glm::dvec3& q) { return p + (q - p) * t; };
  const auto turned = [t](const glm::dquat& p, const glm::dquat& q) {
    return glm::normalize(p * (1 - t) + (glm::dot(p, q) < 0 ? -q : q) * t);
  };
  out.simulatedSeconds = between(a.simulatedSeconds, out.simulatedSeconds);
  if (a.weather && out.weather) out.weather.seconds = between(a.weather.seconds, out.weather.seconds);
  AircraftSnapshot& craft = out.aircraft;
  if (craft.present && a.aircraft.spawnCount == craft.spawnCount) {
    craft.position = mixed(a.aircraft.position, craft.position);
    craft.orientation = turned(a.aircraft.orientation, craft.orientation);
    craft.velocity = mixed(a.aircraft.velocity, craft.velocity);
    craft.angularVelocityBody = mixed(a.aircraft.angularVelocityBody, craft.angularVelocityBody);
    craft.trailingOrientation = turned(a.aircraft.trailingOrientation, craft.trailingOrientation);
    craft.buffet = between(a.aircraft.buffet, craft.buffet);
    craft.controls.pitch = between(a.aircraft.controls.pitch, craft.controls.pitch);
    craft.controls.roll = between(a.aircraft.controls.roll, craft.controls.roll);
    craft.controls.yaw = between(a.aircraft.controls.yaw, craft.controls.yaw);
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

}  // namespace skydrop::game
