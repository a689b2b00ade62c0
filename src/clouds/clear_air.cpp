#include "skydrop/clouds/clear_air.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>
#include <numbers>
#include <utility>
#include <vector>

#include "skydrop/core/hash.h"

namespace skydrop::clouds {
namespace {

// Of the detail's texels, how many wear less than what counts as the least wear.
constexpr double kLessWorn = 0.2;
// Of the ways from clear air into cloud, how many rise faster than what counts as the slope.
constexpr double kSteeper = 0.02;
constexpr int kPlaces = 6000;
constexpr std::array kReachesM = {30.0, 60.0, 120.0, 250.0};
constexpr std::size_t kMostTexels = 32768;  // that are looked at

double quantile(std::vector<float>& values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

// Wear is the detail in the layer's lowest tenth and what it lacks to 1 above.
double leastWear(const std::vector<float>& detail) {
  std::vector<float> some;
  const std::size_t every = detail.size() / kMostTexels | 1;  // odd: no column of a power of two is left out
  for (std::size_t i = 0; i < detail.size(); i += every) some.push_back(detail[i]);
  return std::max(0.0, std::min(quantile(some, kLessWorn), 1 - quantile(some, 1 - kLessWorn)));
}

glm::dvec3 anyDirection(core::RandomStream& random) {
  const double up = 2 * random.nextUnit() - 1, azimuth = 2 * std::numbers::pi * random.nextUnit();
  const double level = std::sqrt(1 - up * up);
  return {level * std::cos(azimuth), up, level * std::sin(azimuth)};
}

}  // namespace

ClearAir measureClearAir(std::shared_ptr<const PackedCloudNoise> noise, const CloudSettings& settings,
                         std::size_t layer) {
  const CloudLayerSettings& s = settings.layers.at(layer);
  ClearAir air;
  air.leastShape = s.erosion * leastWear(noise->detail);
  const CloudField field(std::move(noise), settings, layer);
  const double period = weatherPeriod(s, settings.fadeDistance);
  core::RandomStream random{1, 0};
  std::vector<float> rises;
  for (int i = 0; i < kPlaces; ++i) {
    const glm::dvec3 place(random.nextUnit() * period, s.cloudHeight + s.thickness * random.nextUnit(),
                           random.nextUnit() * period);
    const glm::dvec3 direction = anyDirection(random);
    const float here = field.shapeEstimateInFloat(place);
    for (const double reach : kReachesM) {
      const float there = field.shapeEstimateInFloat(place + direction * reach);
      const bool isBorder = (here < air.leastShape) != (there < air.leastShape);  // there or back
      if (isBorder) rises.push_back(std::abs(there - here) / static_cast<float>(reach));
    }
  }
  if (!rises.empty()) air.slopeM = 1 / quantile(rises, 1 - kSteeper);
  return air;
}

}  // namespace skydrop::clouds
