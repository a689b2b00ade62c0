#include "skydrop/weather/thunder.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "skydrop/core/deterministic_math.h"

namespace skydrop::weather {
namespace {

constexpr double kLapseKPerM = 0.0065;  // of the troposphere (US standard atmosphere 1976)
constexpr double kLoudM = 1000;         // where a clap has half its loudness
constexpr double kFarthestM = 20000;    // beyond it thunder is not heard
constexpr double kFadesFromM = 12000;
constexpr double kDullM = 3000;  // where absorption has taken the upper half of the frequencies

}  // namespace

double speedOfSound(double temperatureC) {
  constexpr double kGasOfAir = 287.05287;  // J/(kg K)
  return std::sqrt(1.4 * kGasOfAir * std::max(temperatureC + 273.15, 1.0));
}

Claps clapsOf(const Flash& flash, const Channel& channel, const glm::dvec3& listener, double temperatureC) {
  Claps claps;
  for (std::size_t i = 0; i < claps.size(); ++i) {
    const glm::dvec3& from = channel.lights[i];
    Clap& clap = claps[i];
    clap.distanceM = glm::length(from - listener);
    const double middleM = std::clamp(0.5 * (from.y + listener.y), 0.0, 11000.0);
    clap.delayS = clap.distanceM / speedOfSound(temperatureC - kLapseKPerM * middleM);
    const double fade = std::clamp((kFarthestM - clap.distanceM) / (kFarthestM - kFadesFromM), 0.0, 1.0);
    clap.gain = kLoudM / (kLoudM + clap.distanceM) * fade * std::min(flash.strength, 1.0);
    clap.dullness = 1 - core::dmath::exp(-clap.distanceM / kDullM);
  }
  return claps;
}

}  // namespace skydrop::weather
