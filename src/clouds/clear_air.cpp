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
#include "skydrop/core/shared.h"

namespace skydrop::clouds {
namespace {

namespace f32 = core::shared::f32;

// Of the detail's texels, how many wear less than what counts as the least wear.
constexpr double kLessWorn = 0.2;
// Of the ways from clear air into cloud, how many rise faster than what counts as the slope.
constexpr double kSteeper = 0.02;
constexpr int kPlaces = 6000, kWornPlaces = 20000;
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

// Constant detail, in [0, 1], that leaves as much cloud of the field as its own detail does: by halving. Wear
// is the detail near the base and what it lacks to 1 above, where nearly all cloud is, so the mean density
// rises with it.
double evenWear(const CloudField& field, double periodM) {
  const CloudLayerSettings& s = field.layer();
  const f32::CloudMedium medium{static_cast<float>(s.densityThreshold), static_cast<float>(s.coverage),
                                static_cast<float>(s.typeShift), static_cast<float>(s.erosion)};
  struct Place {
    float height, shape;
  };
  std::vector<Place> places;
  core::RandomStream random{2, 0};
  double worn = 0;
  for (int i = 0; i < kWornPlaces; ++i) {
    const double height = random.nextUnit(), south = random.nextUnit(), east = random.nextUnit();
    const glm::dvec3 place(east * periodM, s.cloudHeight + s.thickness * height, south * periodM);
    const float shape = field.shapeEstimateInFloat(place);
    if (!(shape > 0)) continue;
    places.push_back({static_cast<float>(height), shape});
    worn += field.densityInFloat(place);
  }
  double low = 0, high = 1;
  for (int i = 0; i < 12; ++i) {
    const double middle = 0.5 * (low + high);
    double left = 0;
    for (const Place& place : places)
      left += f32::erodedDensity(medium, place.height, place.shape, static_cast<float>(middle));
    (left < worn ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

ClearAir measureClearAir(std::shared_ptr<const PackedCloudNoise> noise, const CloudSettings& settings,
                         std::size_t layer) {
  return measureClearAir(std::move(noise), mediumOf(settings, layer));
}

ClearAir measureClearAir(std::shared_ptr<const PackedCloudNoise> noise, const LayerMedium& medium) {
  const CloudLayerSettings& s = medium.layer;
  ClearAir air;
  air.leastShape = s.erosion * leastWear(noise->detail);
  const CloudField field(std::move(noise), medium);
  const double period = weatherPeriod(medium);
  core::RandomStream random{1, 0};
  std::vector<float> rises;
  for (int i = 0; i < kPlaces; ++i) {
    // One after another: compilers draw arguments in orders of their own.
    const double south = random.nextUnit(), height = random.nextUnit(), east = random.nextUnit();
    const glm::dvec3 place(east * period, s.cloudHeight + s.thickness * height, south * period);
    const glm::dvec3 direction = anyDirection(random);
    const float here = field.shapeEstimateInFloat(place);
    for (const double reach : kReachesM) {
      const float there = field.shapeEstimateInFloat(place + direction * reach);
      const bool isBorder = (here < air.leastShape) != (there < air.leastShape);  // there or back
      if (isBorder) rises.push_back(std::abs(there - here) / static_cast<float>(reach));
    }
  }
  air.evenWear = evenWear(field, period);
  if (!rises.empty()) air.slopeM = 1 / quantile(rises, 1 - kSteeper);
  return air;
}

}  // namespace skydrop::clouds
