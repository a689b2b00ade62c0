#include "skydrop/audio/surroundings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>

#include "skydrop/core/guards.h"
#include "skydrop/terrain/woods.h"

namespace skydrop::audio {
namespace {

constexpr std::array<double, 3> kRingsM = {40, 110, 200};
constexpr int kAround = 8;
constexpr double kBirdsHeightM = 55, kWaterHeightM = 70;  // over which their sound falls to 1/e
constexpr double kBirdsReachM = 120;

double risen(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

}  // namespace

Surroundings surroundingsAt(const terrain::HeightSource& ground, bool alpineBelts, const glm::dvec3& ear,
                            double sunElevationDegrees, double windMps) {
  if (!core::isFinite(ear)) return {};
  const glm::dvec2 below(ear.x, ear.z);
  double woods = 0, places = 0, sea = 0, land = 0;
  const auto look = [&](const glm::dvec2& xz, double distanceM) {
    const terrain::HeightSample there = ground.sample(xz);
    (there.height > 0 ? land : sea) += 1;
    if (distanceM > kBirdsReachM) return;
    woods += terrain::forestShare(there, xz, alpineBelts);
    places += 1;
  };
  look(below, 0);
  for (const double ring : kRingsM) {
    for (int i = 0; i < kAround; ++i) {
      constexpr double kPi = 3.14159265358979323846;
      const double turn = 2 * kPi * i / kAround;
      look(below + ring * glm::dvec2(std::cos(turn), std::sin(turn)), ring);
    }
  }
  const double height = std::max(ear.y - std::max(ground.height(below), 0.0), 0.0);
  Surroundings heard;
  heard.birds = std::min(1.5 * woods / places, 1.0) * risen(-4, 6, sunElevationDegrees) *
                (1 - risen(9, 18, windMps)) * std::exp(-height / kBirdsHeightM);
  const double share = sea / (sea + land);                      // of the open sea
  const double shore = std::min(4 * share * (1 - share), 1.0);  // most where half of it is land
  const double waves = share * std::min(0.08 + 0.035 * std::max(windMps, 0.0), 0.6);
  heard.water = std::max(shore * std::min(0.6 + 0.02 * std::max(windMps, 0.0), 1.0), waves) *
                std::exp(-height / kWaterHeightM);
  return heard;
}

Surroundings SurroundingsEar::at(const terrain::HeightSource& ground, bool alpineBelts, const glm::dvec3& ear,
                                 double sunElevationDegrees, double windMps, double simulatedSeconds) {
  const double quarter = std::floor(simulatedSeconds * 4);
  if (asked_ != quarter) {
    asked_ = quarter;
    last_ = surroundingsAt(ground, alpineBelts, ear, sunElevationDegrees, windMps);
  }
  return last_;
}

}  // namespace skydrop::audio
