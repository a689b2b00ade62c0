#include "skydrop/game/contact.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace skydrop::game {
namespace {

// A way is looked at in at most so many pieces, however long it is.
constexpr double kMostSamples = 10000;
// A contact is halved down to this length of way, m.
constexpr double kContactPrecision = 1e-3;

}  // namespace

Surface surfaceAt(const terrain::HeightSource& ground, const glm::dvec2& xz) {
  const double land = ground.height(xz);
  return land > 0 ? Surface{land, false} : Surface{0, true};
}

double clearanceAt(const terrain::HeightSource& ground, const glm::dvec3& position) {
  return position.y - surfaceAt(ground, {position.x, position.z}).height;
}

std::optional<Contact> sweepContact(const terrain::HeightSource& ground, const glm::dvec3& from,
                                    const glm::dvec3& to, double margin, double clearanceAtFrom,
                                    double clearanceAtTo) {
  const auto contactAt = [&](double fraction) {
    const glm::dvec3 point = from + (to - from) * fraction;
    const Surface surface = surfaceAt(ground, {point.x, point.z});
    return Contact{fraction, {point.x, std::max(point.y, surface.height + margin), point.z}, surface.water};
  };
  if (clearanceAtFrom <= margin) return contactAt(0);
  const glm::dvec3 way = to - from;
  const double length = glm::length(way);
  // No land is steeper than the limit, so what is left above it lasts at least this share of the way.
  const double loss = kSteepestSlope * std::sqrt(way.x * way.x + way.z * way.z) + std::abs(way.y);
  const double grain = std::max(kContactGrain / length, 1.0 / kMostSamples);
  const auto left = [&](double fraction) { return clearanceAt(ground, from + way * fraction) - margin; };
  double low = 0, leftAtLow = clearanceAtFrom - margin;
  while (low < 1) {
    double high = low + std::max(leftAtLow / loss, grain);
    if (!(high < 1)) high = 1;  // also where there is no way and no loss
    const double leftAtHigh = high < 1 ? left(high) : clearanceAtTo - margin;
    if (leftAtHigh > 0) {
      low = high;
      leftAtLow = leftAtHigh;
      continue;
    }
    while ((high - low) * length > kContactPrecision) {
      const double middle = 0.5 * (low + high);
      (left(middle) > 0 ? low : high) = middle;
    }
    return contactAt(high);
  }
  return {};
}

}  // namespace skydrop::game
