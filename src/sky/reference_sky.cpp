#include "skydrop/sky/reference_sky.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "skydrop/core/hash.h"

namespace skydrop::sky {
namespace {

namespace f64 = core::shared::f64;
using glm::dvec3;

constexpr int kSines = 256, kHeights = 128, kTableSteps = 128;
constexpr int kFirstSteps = 256;   // among which the first scattering of a path is chosen
constexpr double kRoulette = 0.1;  // paths that carry less go on by chance

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

// A direction at an angle to another.
dvec3 turned(const dvec3& direction, double cosine, double azimuth) {
  const dvec3 aside = std::abs(direction.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
  const dvec3 u = glm::normalize(glm::cross(direction, aside)), v = glm::cross(direction, u);
  const double sine = std::sqrt(std::max(1 - cosine * cosine, 0.0));
  return glm::normalize(direction * cosine + (u * std::cos(azimuth) + v * std::sin(azimuth)) * sine);
}

// The cosine that a share of Rayleigh's phase function lies below of: a cubic with one real root.
double rayleighCosine(double share) {
  const double q = 4 * share - 2, d = std::cbrt(q + std::sqrt(q * q + 1));
  return std::clamp(d - 1 / d, -1.0, 1.0);
}

double henyeyGreensteinCosine(double share, double g) {
  if (std::abs(g) < 1e-3) return 2 * share - 1;
  const double s = (1 - g * g) / (1 - g + 2 * g * share);
  return std::clamp((1 + g * g - s * s) / (2 * g), -1.0, 1.0);
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

double endOf(const ReferenceRay& ray) {
  const f64::Vec2 ground = f64::shellCrossing(ray.heightM, ray.sine, 0);
  if (ray.sine < f64::horizonSine(ray.heightM) && ground.x <= ground.y) return std::max(ground.x, 0.0);
  return f64::shellCrossing(ray.heightM, ray.sine, f64::kShellTop).y;
}

double betweenOf(const ReferenceRay& ray) {
  return ray.sine * ray.sunSine + ray.cosAzimuth * std::sqrt(std::max(1 - ray.sine * ray.sine, 0.0)) *
                                      std::sqrt(std::max(1 - ray.sunSine * ray.sunSine, 0.0));
}

}  // namespace

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

double ReferenceSky::pathOf(const ReferenceRay& ray, int channel, const std::vector<double>& opacities,
                            double length, std::uint64_t seed) const {
  core::RandomStream random{seed};
  const dvec3 toSun(std::sqrt(std::max(1 - ray.sunSine * ray.sunSine, 0.0)), ray.sunSine, 0);
  const double across = std::sqrt(std::max(1 - ray.sine * ray.sine, 0.0));
  dvec3 direction(across * ray.cosAzimuth, ray.sine,
                  across * std::sqrt(std::max(1 - ray.cosAzimuth * ray.cosAzimuth, 0.0)));
  // The first scattering is forced to happen.
  double weight = opacities.back();
  const auto chosen = std::upper_bound(opacities.begin(), opacities.end(), random.nextUnit() * weight);
  const double k = static_cast<double>(std::min(chosen, opacities.end() - 1) - opacities.begin());
  const double begin = length * k * k / (kFirstSteps * kFirstSteps),
               end = length * (k + 1) * (k + 1) / (kFirstSteps * kFirstSteps);
  dvec3 place =
      dvec3(0, f64::kEarthRadius + ray.heightM, 0) + direction * (begin + (end - begin) * random.nextUnit());
  bool onGround = false;
  double sum = 0;
  for (int order = 1; order < 1000; ++order) {
    const double r = glm::length(place), height = std::max(r - f64::kEarthRadius, 0.0);
    const dvec3 up = place / r;
    const double sun = glm::dot(up, toSun), light = order > 1 ? sunLight(height, sun)[channel] : 0;
    if (onGround) {
      weight *= f64::kGroundAlbedo;
      sum += weight * light * std::max(sun, 0.0) / std::numbers::pi;
      direction = turned(up, std::sqrt(random.nextUnit()), 2 * std::numbers::pi * random.nextUnit());
    } else {
      const f64::ShellAir here = f64::shellAirAt(air_, height);
      const double air = here.rayleigh[channel], scattering = air + here.haze;
      weight *= scattering / here.extinction[channel];
      const double between = glm::dot(direction, toSun);
      sum += weight * light *
             (air * f64::rayleighPhase(between) +
              here.haze * f64::henyeyGreenstein(between, air_.hazeAnisotropy)) /
             scattering;
      const double cosine = random.nextUnit() * scattering < air
                                ? rayleighCosine(random.nextUnit())
                                : henyeyGreensteinCosine(random.nextUnit(), air_.hazeAnisotropy);
      direction = turned(direction, cosine, 2 * std::numbers::pi * random.nextUnit());
    }
    if (weight < kRoulette) {
      if (random.nextUnit() >= weight / kRoulette) return sum;
      weight = kRoulette;
    }
    // The next scattering, by steps through air as dense as anywhere along the ray (Woodcock and others
    // 1965).
    const double climb = glm::dot(direction, place / r);
    const bool falls = climb < f64::horizonSine(height);
    const double way = std::max(
        falls ? f64::shellCrossing(height, climb, 0).x : f64::shellCrossing(height, climb, f64::kShellTop).y,
        0.0);
    const double lowest =
        falls        ? 0.0
        : climb >= 0 ? height
                     : std::max(height - r * climb * climb / (1 + std::sqrt(1 - climb * climb)), 0.0);
    const double most = air_.rayleigh[channel] * f64::densityAt(lowest, air_.rayleighHeight) +
                        air_.haze * f64::densityAt(lowest, air_.hazeHeight) + air_.ozone[channel];
    double t = 0;
    for (;;) {
      t -= std::log(1 - random.nextUnit()) / most;
      if (t >= way) break;
      const double there = f64::shellHeightAlong(height, climb, t);
      if (random.nextUnit() * most < f64::shellAirAt(air_, there).extinction[channel]) break;
    }
    onGround = t >= way;
    if (onGround && !falls) return sum;
    place += direction * std::min(t, way);
  }
  return sum;
}

ReferenceEstimate ReferenceSky::often(const ReferenceRay& ray, int channel, int paths,
                                      std::uint32_t seed) const {
  const double length = endOf(ray);
  std::vector<double> opacities;  // of the way up to the end of each step
  double left = 1, opacity = 0;
  for (int i = 0; i < kFirstSteps; ++i) {
    const double from = length * i * i / (kFirstSteps * kFirstSteps),
                 to = length * (i + 1.0) * (i + 1.0) / (kFirstSteps * kFirstSteps);
    const double height = f64::shellHeightAlong(ray.heightM, ray.sine, 0.5 * (from + to));
    const double kept = std::exp(-f64::shellAirAt(air_, height).extinction[channel] * (to - from));
    opacity += left * (1 - kept);
    left *= kept;
    opacities.push_back(opacity);
  }
  double sum = 0, squares = 0;
  for (int path = 0; path < paths; ++path) {
    const double value =
        pathOf(ray, channel, opacities, length,
               core::hashCombine(seed * std::uint64_t{3} + static_cast<std::uint64_t>(channel),
                                 static_cast<std::uint64_t>(path)));
    sum += value;
    squares += value * value;
  }
  const double mean = sum / paths;
  return {mean, std::sqrt(std::max(squares / paths - mean * mean, 0.0) / paths)};
}

}  // namespace skydrop::sky
