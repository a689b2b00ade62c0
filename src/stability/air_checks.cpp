#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <initializer_list>

#include "skydrop/sky/almanac.h"
#include "skydrop/weather/dryden.h"
#include "skydrop/weather/standard_atmosphere.h"
#include "skydrop/weather/wind_profile.h"
#include "stability/checks.h"

namespace skydrop::stability {
namespace {

// Table 4 of the U.S. Standard Atmosphere (1976).
struct Border {
  double geopotentialM, temperatureK, pressurePa;
};
constexpr Border kBorders[] = {{0, 288.15, 101325},       {11000, 216.65, 22632.06},
                               {20000, 216.65, 5474.889}, {32000, 228.65, 868.0187},
                               {47000, 270.65, 110.9063}, {51000, 270.65, 66.93887},
                               {71000, 214.65, 3.956420}, {84852, 186.946, 0.3733836}};

template <class Error>
double worstOfBorders(const Error& error) {
  double worst = 0;
  for (const Border& border : kBorders) {
    const double h = border.geopotentialM, height = 6356766 * h / (6356766 - h);
    worst = std::max(worst, error(weather::standardAir(height), border));
  }
  return worst;
}

}  // namespace

double windTurnJump() {
  double before = 350, worst = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double at = weather::mixedDirection(350, 8, 10, 8, i / 1000.0);
    worst = std::max(worst, std::abs(std::remainder(at - before, 360)));
    before = at;
  }
  return worst;
}

// P = F P F^T + L L^T with P = [1/2 1/4; 1/4 1/4].
double gustCovarianceError() {
  double worst = 0;
  for (double a = 1e-12; a < 2e3; a *= 3) {
    const weather::DrydenStep step({glm::dvec3(1), glm::dvec3(1)}, a, 1);
    const auto& t = step.v;
    const double k = t.keep, f = t.feed;
    worst = std::max(
        {worst, std::abs(k * k / 2 + t.noise11 * t.noise11 - 0.5),
         std::abs(k * (f / 2 + k / 4) + t.noise11 * t.noise21 - 0.25),
         std::abs(f * f / 2 + f * k / 2 + k * k / 4 + t.noise21 * t.noise21 + t.noise22 * t.noise22 - 0.25),
         std::abs(step.keepU * step.keepU + step.noiseU * step.noiseU - 1)});
  }
  return worst;
}

double standardPressureError() {
  return worstOfBorders([](const weather::Air& air, const Border& border) {
    return std::abs(air.pressurePa / border.pressurePa - 1);
  });
}

double standardTemperatureError() {
  return worstOfBorders([](const weather::Air& air, const Border& border) {
    return std::abs(air.temperatureK - border.temperatureK);
  });
}

double yearsEndMotion() {
  double worst = 0;
  for (const char* utc : {"1950-01-01", "2051-01-01", "2050-01-01", "2000-01-01", "2025-01-01",
                          "1000-01-01T00:00:01", "1700-01-01", "2100-01-01", "3000-12-31T23:59:58"}) {
    const double days = sky::daysSinceJ2000(sky::parseInstant(utc)), second = 1.0 / 86400;
    for (const sky::Place& place : {sky::Place{0, 0}, sky::Place{52, 13}, sky::Place{-77, 166}}) {
      for (const auto bodyAt : {sky::sunAt, sky::moonAt}) {
        const auto before = sky::worldDirection(bodyAt(days - second, place).horizontal);
        const auto after = sky::worldDirection(bodyAt(days + second, place).horizontal);
        worst = std::max(worst, glm::degrees(glm::length(after - before)));
      }
    }
  }
  return worst;
}

}  // namespace skydrop::stability
