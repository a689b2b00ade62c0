#include "skydrop/clouds/reference_march.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "skydrop/clouds/raised_sun.h"
#include "skydrop/core/error.h"
#include "skydrop/core/shared.h"

namespace skydrop::clouds {
namespace {

namespace f64 = core::shared::f64;

void requireUnit(const glm::dvec3& direction, std::string_view name) {
  constexpr double kRounding = 1e-5;  // of a vector that was made in 32 bits
  if (std::abs(glm::dot(direction, direction) - 1) <= kRounding) return;
  throw core::RangeError("the direction " + std::string(name) + " has to be of length 1");
}

// In the field rays through a shell are bent.
double bendOf(const MarchMedium& medium, const MarchRay& ray) {
  return medium.isShell ? f64::rayBend(ray.direction) : 0;
}

f64::RaySpan layerOf(const MarchMedium& medium, const MarchRay& ray) {
  if (!medium.isShell) return f64::raySpanBetween(ray.origin.y, ray.direction.y, medium.baseM, medium.topM);
  const double bend = bendOf(medium, ray);
  return f64::bentRayInLayer(f64::bentRayUnder(ray.origin.y - medium.topM, ray.direction.y, bend),
                             f64::bentRayUnder(ray.origin.y - medium.baseM, ray.direction.y, bend),
                             std::min(ray.endM, medium.fadeDistanceM));
}

}  // namespace

MarchMedium mediumOf(const CloudField& field) {
  const CloudLayerSettings& layer = field.layer();
  return {[&field](const glm::dvec3& place) { return field.density(place) * field.layer().extinction; },
          layer.cloudHeight, layer.cloudHeight + layer.thickness, field.fadeDistance(), true};
}

double sunDepth(const MarchMedium& medium, const glm::dvec3& toSun, const glm::dvec3& place, int samples) {
  requireUnit(toSun, "to the sun");
  const glm::dvec3 direction = raisedSun(toSun);
  const f64::RaySpan span = f64::raySpanBetween(place.y, direction.y, medium.baseM, medium.topM);
  const double way = span.end - span.begin;
  double depth = 0;
  for (int i = 0; i < samples; ++i) {
    const double begin = f64::sunPartBegin(i, samples, way), end = f64::sunPartBegin(i + 1, samples, way);
    depth += medium.extinction(place + direction * (span.begin + (begin + end) / 2)) * (end - begin);
  }
  return depth;
}

glm::dvec3 octavesOfLight(const LitPlace& at) {
  return {f64::scatteredSun(f64::Vec4(at.sunPhases), at.sunDepth), f64::scatteredSky(at.heightFraction),
          f64::scatteredGround(at.heightFraction)};
}

MarchResult referenceMarch(const MarchMedium& medium, const MarchLight& light, const MarchRay& ray,
                           const MarchSteps& steps) {
  return referenceMarch(medium, light, ray, steps, octavesOfLight);
}

MarchResult referenceMarch(const MarchMedium& medium, const MarchLight& light, const MarchRay& ray,
                           const MarchSteps& steps, const ScatteredLight& scattered) {
  requireUnit(light.toSun, "to the sun");
  requireUnit(ray.direction, "of the ray");
  const f64::RaySpan span = f64::overlap(
      layerOf(medium, ray), f64::make_raySpan(ray.beginM, std::min(ray.endM, medium.fadeDistanceM)));
  const double bend = bendOf(medium, ray);
  MarchResult result;
  const double thickness = medium.topM - medium.baseM;
  if (steps.steps <= 0 || !(span.end > span.begin && thickness > 0)) return result;

  const double step = (span.end - span.begin) / steps.steps;
  const double cosine = glm::dot(ray.direction, light.toSun);
  const f64::Vec4 phases = f64::cloudPhases(cosine, light.anisotropy, light.forwardShare);
  double passed = 0, opacity = 0, distance = 0;
  for (int i = 0; i < steps.steps; ++i) {
    const double at = span.begin + (i + 0.5) * step;
    const glm::dvec3 place = ray.origin + f64::placeOnBentRay(ray.direction, bend, at);
    const double extinction = medium.extinction(place);
    const double depth = extinction * f64::cloudFade(at, medium.fadeDistanceM) * step;
    const bool isBetween = medium.isShell && (place.y < medium.baseM || place.y > medium.topM);
    if (isBetween || !(depth > 0)) continue;
    // expm1 and one exp of the sum: the shared series is made for 32 bits.
    const double share = std::exp(-passed) * -std::expm1(-depth);
    passed += depth;
    const bool isLit = light.toSun.y > 0;
    const double sunDepthThere = isLit ? sunDepth(medium, light.toSun, place, steps.sunSamples) : 0;
    const glm::dvec3 from =
        scattered({place, (place.y - medium.baseM) / thickness, sunDepthThere, extinction, phases, cosine});
    if (isLit) result.sun += share * from.x;
    result.sky += share * from.y;
    result.ground += share * from.z;
    opacity += share;
    distance += share * at;
  }
  result.transmittance = std::exp(-passed);
  if (opacity > 0) result.distanceM = distance / opacity;
  return result;
}

}  // namespace skydrop::clouds
