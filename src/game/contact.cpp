#include "skydrop/game/contact.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace skydrop::game {

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
  const double sideways = std::sqrt(way.x * way.x + way.z * way.z);
  // Between the ends the clearance cannot fall further than the land can rise and the path can sink.
  if (std::min(clearanceAtFrom, clearanceAtTo) - margin > kSteepestSlope * sideways + std::abs(way.y))
    return {};
  const auto clear = [&](double fraction) { return clearanceAt(ground, from + way * fraction) - margin; };
  const int pieces = std::max(1, static_cast<int>(std::ceil(std::min(length / kContactSample, 1e5))));
  double low = 0;
  for (int i = 1; i <= pieces; ++i) {
    double high = static_cast<double>(i) / pieces;
    if ((i == pieces ? clearanceAtTo - margin : clear(high)) > 0) {
      low = high;
      continue;
    }
    while ((high - low) * length > 1e-3) {  // halving the piece, to a millimetre
      const double middle = 0.5 * (low + high);
      (clear(middle) > 0 ? low : high) = middle;
    }
    return contactAt(high);
  }
  return {};
}

}  // namespace skydrop::game
