#include "skydrop/sky/reference_sky.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>

#include "skydrop/sky/air_tables.h"
#include "skydrop/sky/reference_paths.h"

namespace skydrop::sky {
namespace {

namespace f64 = core::shared::f64;
using glm::dvec3;

constexpr int kSines = 256, kHeights = 128, kTableSteps = 128;
constexpr int kExpectedHeights = 48, kExpectedSines = 96;

// Of a ray that does not go down.
dvec3 risingDepth(const f64::Atmosphere& air, double heightM, double cosine, int steps) {
  const double length = f64::shellCrossing(heightM, cosine, f64::kShellTop).y;
  dvec3 depth(0);
  for (int i = 0; i < steps; ++i) {
    const double at = (i + 0.5) / steps;
    depth += f64::shellAirAt(air, f64::shellHeightAlong(heightM, cosine, length * at * at * at)).extinction *
             (3 * at * at);
  }
  return depth * (std::max(length, 0.0) / steps);
}

}  // namespace

ReferenceSky::ReferenceSky(const f64::Atmosphere& air) : air_(air) {
  // transmittanceTablePlace, with its own number of texels.
  depths_.reserve(static_cast<std::size_t>(kSines * kHeights));
  for (int y = 0; y < kHeights; ++y) {
    for (int x = 0; x < kSines; ++x) {
      const f64::Vec2 place = f64::transmittanceTablePlace({x / (kSines - 1.0), y / (kHeights - 1.0)});
      depths_.push_back(depth(place.x, place.y, kTableSteps));
    }
  }
  makeExpected();
}

dvec3 ReferenceSky::depth(double heightM, double cosine, int steps) const {
  if (cosine >= 0) return risingDepth(air_, heightM, cosine, steps);
  // Down to where the ray is level, and up again: of twice the level ray's, what lies above the height is
  // missing.
  const double r = f64::kEarthRadius + heightM;
  const double lowest = std::max(heightM - r * cosine * cosine / (1 + std::sqrt(1 - cosine * cosine)), 0.0);
  return 2.0 * risingDepth(air_, lowest, 0, steps) - risingDepth(air_, heightM, -cosine, steps);
}

dvec3 ReferenceSky::transmittance(double heightM, double cosine, int steps) const {
  if (cosine < f64::horizonSine(heightM)) return dvec3(0);
  return glm::exp(-depth(heightM, cosine, steps));
}

dvec3 ReferenceSky::sunLight(double heightM, double cosine) const {
  const double share = f64::sunVisibleShareAt(heightM, cosine);
  if (share <= 0) return dvec3(0);
  const f64::Vec2 at = f64::transmittanceTableAt(heightM, cosine);
  const double x = at.x * (kSines - 1), y = at.y * (kHeights - 1);
  const int i = std::min(static_cast<int>(x), kSines - 2), j = std::min(static_cast<int>(y), kHeights - 2);
  const dvec3* texel = &depths_[static_cast<std::size_t>(j * kSines + i)];
  return share * glm::exp(-glm::mix(glm::mix(texel[0], texel[1], x - i),
                                    glm::mix(texel[kSines], texel[kSines + 1], x - i), y - j));
}

namespace {

// Elevations are close to each other where the light is level, heights at the ground.
double sineOfColumn(int column) {
  const double x = 2.0 * column / (kExpectedSines - 1) - 1;
  return x * std::abs(x);
}

}  // namespace

void ReferenceSky::makeExpected() {
  const AirTables tables(air_);
  expected_.reserve(static_cast<std::size_t>(kExpectedHeights * kExpectedSines));
  for (int y = 0; y < kExpectedHeights; ++y) {
    const double share = y / (kExpectedHeights - 1.0);
    const AirTables::Level level = tables.at(static_cast<float>(f64::kShellTop * share * share));
    for (int x = 0; x < kExpectedSines; ++x)
      expected_.push_back(
          glm::max(dvec3(level.scatteredBefore(static_cast<float>(sineOfColumn(x))).mean), dvec3(1e-12)));
  }
}

dvec3 ReferenceSky::expected(double heightM, double sunSine) const {
  const double y = std::sqrt(std::clamp(heightM / f64::kShellTop, 0.0, 1.0)) * (kExpectedHeights - 1);
  const double x = 0.5 * (1 + std::copysign(std::sqrt(std::abs(sunSine)), sunSine)) * (kExpectedSines - 1);
  const int i = std::clamp(static_cast<int>(x), 0, kExpectedSines - 2),
            j = std::clamp(static_cast<int>(y), 0, kExpectedHeights - 2);
  const dvec3* texel = &expected_[static_cast<std::size_t>(j * kExpectedSines + i)];
  return glm::mix(glm::mix(texel[0], texel[1], x - i),
                  glm::mix(texel[kExpectedSines], texel[kExpectedSines + 1], x - i), y - j);
}

double endOf(const ReferenceRay& ray) {
  const f64::Vec2 ground = f64::shellCrossing(ray.heightM, ray.sine, 0);
  if (ray.sine < f64::horizonSine(ray.heightM) && ground.x <= ground.y) return std::max(ground.x, 0.0);
  return f64::shellCrossing(ray.heightM, ray.sine, f64::kShellTop).y;
}

double betweenOf(const ReferenceRay& ray) {
  return ray.sine * ray.sunSine + ray.cosAzimuth * std::sqrt(std::max(1 - ray.sine * ray.sine, 0.0)) *
                                      std::sqrt(std::max(1 - ray.sunSine * ray.sunSine, 0.0));
}

dvec3 ReferenceSky::once(const ReferenceRay& ray, int steps) const {
  const double between = betweenOf(ray), length = endOf(ray);
  const double byAir = f64::rayleighPhase(between),
               byHaze = f64::henyeyGreenstein(between, air_.hazeAnisotropy);
  dvec3 light(0), depthSoFar(0);
  for (int i = 0; i < steps; ++i) {
    const double a = static_cast<double>(i) / steps, b = (i + 1.0) / steps;
    const double from = length * a * a, to = length * b * b, t = 0.5 * (from + to);
    const double height = f64::shellHeightAlong(ray.heightM, ray.sine, t);
    const f64::ShellAir here = f64::shellAirAt(air_, height);
    const double sun = std::clamp(
        ((f64::kEarthRadius + ray.heightM) * ray.sunSine + t * between) / (f64::kEarthRadius + height), -1.0,
        1.0);
    const double share = f64::sunVisibleShareAt(height, sun);
    if (share > 0) {
      const double above = std::max(sun, f64::horizonSine(height));
      light += glm::exp(-depthSoFar - here.extinction * (0.5 * (to - from)) -
                        depth(height, above, std::max(steps / 4, 16))) *
               (here.rayleigh * byAir + dvec3(here.haze * byHaze)) * (share * (to - from));
    }
    depthSoFar += here.extinction * (to - from);
  }
  return light;
}

ReferenceEstimate ReferenceSky::often(const ReferenceRay& ray, int paths, std::uint64_t seed) const {
  return ReferencePaths(*this, ray, seed).upTo(paths);
}

}  // namespace skydrop::sky
