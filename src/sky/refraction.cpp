#include "skydrop/sky/refraction.h"

#include <algorithm>

#include "skydrop/core/deterministic_math.h"

namespace skydrop::sky {
namespace {

namespace dmath = core::dmath;

constexpr double kLowest = -1;  // of what the formula is asked for

double saemundsson(double elevation) {
  const double angle = (elevation + 10.3 / (elevation + 5.11)) * dmath::kRadPerDeg;
  // Their constant makes it 0 at the zenith.
  return (1.02 * dmath::cos(angle) / dmath::sin(angle) + 0.0019279) / 60;
}

}  // namespace

double refraction(double geometricElevationDegrees) {
  const double elevation = std::clamp(geometricElevationDegrees, -90.0, 90.0);
  if (elevation >= kLowest) return std::max(saemundsson(elevation), 0.0);
  return saemundsson(kLowest) * (elevation + 90) / (kLowest + 90);
}

Horizontal refracted(const Horizontal& geometric) {
  return {geometric.azimuthDegrees,
          std::min(geometric.elevationDegrees + refraction(geometric.elevationDegrees), 90.0)};
}

double geometricElevation(double apparentElevationDegrees) {
  // The appearance grows with the elevation, so that halving finds it.
  const double apparent = std::clamp(apparentElevationDegrees, -90.0, 90.0);
  double low = std::max(apparent - 1, -90.0), high = apparent;
  for (int i = 0; i < 40; ++i) {
    const double middle = (low + high) / 2;
    (middle + refraction(middle) < apparent ? low : high) = middle;
  }
  return high;
}

}  // namespace skydrop::sky
