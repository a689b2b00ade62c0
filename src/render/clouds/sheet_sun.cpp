#include "render/clouds/sheet_sun.h"

#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <numbers>

namespace skydrop::render {
namespace {

constexpr double kEarthRadiusM = core::shared::f64::kEarthRadius;

// With the sun's whole disc in view.
glm::dvec3 sunAt(const SkyLight& light, double heightM, double sine) {
  sky::SkyLight there = light.direct;
  there.toSun.y = std::max(sine, kSunRadiusRad);
  return sky::sunIlluminance(there, heightM);
}

}  // namespace

glm::dvec3 sunOnSheet(const SkyLight& light, double heightM) {
  if (light.isShell()) return sky::sunIlluminance(light.direct, heightM) * light.exposure;
  const double sine = light.direct.toSun.y;
  if (sine >= 0) return sunAt(light, heightM, sine) * light.exposure;
  // The ray passes its lowest point, where it is level, before it reaches the sheet: out from there through
  // the air as seen from that height, and in through a share of as much again. Half of a level way through
  // the atmosphere counts as sqrt(pi R H / 2) of air as dense as at its lowest point.
  const double lowest = heightM - kEarthRadiusM * sine * sine / 2;
  const double half = std::sqrt(std::numbers::pi / 2 * kEarthRadiusM * light.air.rayleighHeight);
  const double share = std::min(-sine * kEarthRadiusM / half, 1.0);
  const glm::dvec3 outside = glm::max(light.direct.sunOutside, glm::dvec3(1e-12));
  const glm::dvec3 out = glm::max(sunAt(light, std::max(lowest, 0.0), 0) / outside, glm::dvec3(1e-12));
  // The disc sets behind the ground over so many metres of its height there.
  const double disc = std::max(2 * kSunRadiusRad * -sine * kEarthRadiusM, 1.0);
  const double seen = std::clamp(lowest / disc + 0.5, 0.0, 1.0);
  return outside * glm::pow(out, glm::dvec3(1 + share)) * (seen * light.exposure);
}

}  // namespace skydrop::render
