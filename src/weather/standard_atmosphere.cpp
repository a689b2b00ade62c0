#include "skydrop/weather/standard_atmosphere.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "skydrop/core/deterministic_math.h"

namespace skydrop::weather {
namespace {

namespace dmath = core::dmath;

constexpr double kEarthRadius = 6356766;  // m, that gives the standard's gravity
constexpr double kGravity = 9.80665;      // m/s^2
constexpr double kGasConstant = 8314.32;  // J/(kmol K), that of 1976
constexpr double kMolarMass = 28.9644;    // kg/kmol
constexpr double kAirConstant = kGasConstant / kMolarMass;
constexpr double kHeatRatio = 1.4;

struct Stratum {
  double baseM;  // geopotential
  double lapse;  // K/m
  double baseK;
  double basePa;  // follows from those below
};

// Table 4 of the standard; the last entry ends at 84 852 m, which is 86 km.
std::array<Stratum, 7> makeStrata() {
  std::array<Stratum, 7> strata{{{0, -0.0065, 288.15, 101325},
                                 {11000, 0, 0, 0},
                                 {20000, 0.001, 0, 0},
                                 {32000, 0.0028, 0, 0},
                                 {47000, 0, 0, 0},
                                 {51000, -0.0028, 0, 0},
                                 {71000, -0.002, 0, 0}}};
  for (std::size_t i = 1; i < strata.size(); ++i) {
    const Stratum& below = strata[i - 1];
    const double rise = strata[i].baseM - below.baseM;
    strata[i].baseK = below.baseK + below.lapse * rise;
    strata[i].basePa = below.lapse == 0
                           ? below.basePa * dmath::exp(-kGravity * rise / (kAirConstant * below.baseK))
                           : below.basePa * dmath::pow(below.baseK / strata[i].baseK,
                                                       kGravity / (kAirConstant * below.lapse));
  }
  return strata;
}

struct Column {
  double temperatureK, pressurePa;
};

Column columnAt(double geopotential) {
  static const std::array<Stratum, 7> strata = makeStrata();
  std::size_t i = strata.size() - 1;
  while (i > 0 && geopotential < strata[i].baseM) --i;
  const Stratum& s = strata[i];
  const double rise = geopotential - s.baseM;
  const double temperature = s.baseK + s.lapse * rise;
  if (s.lapse == 0) return {temperature, s.basePa * dmath::exp(-kGravity * rise / (kAirConstant * s.baseK))};
  return {temperature, s.basePa * dmath::pow(s.baseK / temperature, kGravity / (kAirConstant * s.lapse))};
}

Air airOf(double temperatureK, double pressurePa) {
  return {temperatureK, pressurePa, pressurePa / (kAirConstant * temperatureK),
          std::sqrt(kHeatRatio * kAirConstant * temperatureK)};
}

Column standardColumn(double heightM) {
  const double height = std::isnan(heightM) ? 0 : std::max(heightM, kStandardFromM);
  if (height <= kStandardToM) return columnAt(geopotentialHeight(height));
  const double top = geopotentialHeight(kStandardToM);
  const Column edge = columnAt(top);
  const double rise = geopotentialHeight(std::min(height, 1e12)) - top;
  return {edge.temperatureK,
          edge.pressurePa * dmath::exp(-kGravity * rise / (kAirConstant * edge.temperatureK))};
}

}  // namespace

double geopotentialHeight(double heightM) { return kEarthRadius * heightM / (kEarthRadius + heightM); }

Air standardAir(double heightM) {
  const Column column = standardColumn(heightM);
  return airOf(column.temperatureK, column.pressurePa);
}

Air airAt(double heightM, double seaTemperatureC, double seaPressurePa) {
  const Column column = standardColumn(heightM);
  return airOf(column.temperatureK + (seaTemperatureC - 15), column.pressurePa * (seaPressurePa / 101325));
}

}  // namespace skydrop::weather
