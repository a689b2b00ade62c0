#include "render/clouds/cloud_uniforms.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "skydrop/clouds/occupancy.h"

namespace skydrop::render {
namespace {

namespace shared = core::shared::f64;

glm::vec4 packed(const glm::dvec3& xyz, double w) { return glm::vec4(glm::vec3(xyz), static_cast<float>(w)); }

// In periods, [0, 1): wrapped in double before anything is rounded.
glm::vec4 inPeriods(const glm::dvec3& place, double period) {
  const glm::dvec3 periods = place / period;
  return packed(periods - glm::floor(periods), 1 / period);
}

}  // namespace

CloudUniforms fieldUniforms(const clouds::CloudSettings& s, const glm::dvec3& place, double meanDetail) {
  CloudUniforms u{};
  u.shapePlace = inPeriods(place, clouds::shapePeriod(s));
  u.detailPlace = inPeriods(place, clouds::detailPeriod(s));
  u.weatherPlace = inPeriods(place, clouds::weatherPeriod(s));
  u.layer = glm::vec4(s.cloudHeight - place.y, s.thickness, s.fadeDistance, s.extinction);
  u.medium = glm::vec4(s.densityThreshold, s.coverage, s.typeShift, s.erosion);
  u.scattering = glm::vec4(s.anisotropy, s.forwardShare, meanDetail, 0);
  const double cellsAPeriod = clouds::Occupancy::kSide;
  u.cells = glm::vec4(u.weatherPlace.x * clouds::Occupancy::kSide, cellsAPeriod / clouds::weatherPeriod(s),
                      u.weatherPlace.z * clouds::Occupancy::kSide, clouds::Occupancy::kRows / s.thickness);
  return u;
}

glm::dvec3 raisedSun(const glm::dvec3& toSun) {
  const double sine = static_cast<double>(shared::kLeastSunSine);
  if (toSun.y >= sine) return toSun;
  const glm::dvec2 level(toSun.x, toSun.z);
  const double length = glm::length(level);
  const glm::dvec2 direction = length > 1e-9 ? level / length : glm::dvec2(1, 0);
  const glm::dvec2 scaled = direction * std::sqrt(1 - sine * sine);
  return {scaled.x, sine, scaled.y};
}

void addLight(CloudUniforms& u, const clouds::CloudSettings& s, const SkyLight& light) {
  u.toSun = packed(raisedSun(light.toSun), s.march.sunMarchDistanceM);
  const double middle = s.cloudHeight + 0.5 * s.thickness;
  u.sunLight = packed(sky::sunIlluminance(light, middle) * light.exposure, 0);
  u.skyLight = packed(light.sky * light.exposure, 0);
  u.groundLight = packed(light.ground * light.exposure, 0);
}

void addMarch(CloudUniforms& u, const clouds::MarchSettings& march, const View& view, int tilePixels) {
  u.march = glm::vec4(march.stepM, march.stepGrowth, march.maxSegmentOpticalDepth, march.transmittanceCutoff);
  // Where steps begin to grow: an even number of them, so that longer steps begin at multiples of themselves.
  const double growthBegins = march.stepM * 2 * std::round(0.5 / march.stepGrowth);
  // Of a tile in the middle of the picture; elsewhere it is seen under a smaller angle.
  const double halfDiagonal = 1.02 * std::sqrt(0.5) * tilePixels * view.pixelAngleRad();
  u.sight = glm::vec4(growthBegins, halfDiagonal, march.tolerance, march.emptyStepMultiplier);
}

}  // namespace skydrop::render
