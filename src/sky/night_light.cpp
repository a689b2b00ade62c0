#include "skydrop/sky/night_light.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

namespace skydrop::sky {
namespace {

constexpr double kFullMoonMagnitude = -12.73, kMeanDistanceKm = 384400;
// Beyond this next to nothing of the disc is lit, and the ratio of two numbers near 0 says nothing.
constexpr double kThinnestDegrees = 170;

// Chromaticity of a black body, 1667 to 25000 K.
glm::dvec2 chromaticity(double kelvin) {
  const double t = 1e3 / std::clamp(kelvin, 1667.0, 25000.0);
  const double x = kelvin <= 4000 ? ((-0.2661239 * t - 0.2343589) * t + 0.8776956) * t + 0.179910
                                  : ((-3.0258469 * t + 2.1070379) * t + 0.2226347) * t + 0.240390;
  const double y = kelvin <= 2222   ? ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683
                   : kelvin <= 4000 ? ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867
                                    : ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483;
  return {x, y};
}

}  // namespace

double illuminanceOfMagnitude(double magnitude) { return 1e-3 * std::pow(10.0, -0.4 * (magnitude + 13.98)); }

glm::dvec3 starColor(double colorIndex) {
  const double b = std::clamp(colorIndex, -0.4, 6.0);
  const double kelvin = 4600 * (1 / (0.92 * b + 1.7) + 1 / (0.92 * b + 0.62));
  const glm::dvec2 c = chromaticity(kelvin);
  const glm::dvec3 xyz(c.x / c.y, 1, (1 - c.x - c.y) / c.y);
  // XYZ to linear sRGB, column by column (IEC 61966-2-1).
  const glm::dmat3 toRgb(3.2406, -0.9689, 0.0557, -1.5372, 1.8758, -0.2040, -0.4986, 0.0415, 1.0570);
  const glm::dvec3 rgb = glm::max(toRgb * xyz, glm::dvec3(0));
  return rgb / glm::dot(rgb, glm::dvec3(0.2126, 0.7152, 0.0722));
}

double moonIlluminance(double phaseAngleDegrees, double distanceKm) {
  const double a = std::clamp(std::abs(phaseAngleDegrees), 0.0, 180.0);
  const double near = kMeanDistanceKm / distanceKm;
  return illuminanceOfMagnitude(kFullMoonMagnitude + 0.026 * a + 4e-9 * a * a * a * a) * near * near;
}

double lommelSeeligerShare(double phaseAngleDegrees) {
  const double half = 0.5 * glm::radians(std::clamp(std::abs(phaseAngleDegrees), 0.0, 180.0));
  if (half < 1e-9) return 1;
  // Near the new moon the sum is a difference of like numbers, by less than rounding below 0: its series
  // there.
  const double left = 0.5 * std::numbers::pi - half;
  if (left < 0.01) return left * left * (2.0 / 3 - 4.0 / 45 * left * left);
  return 1 + std::sin(half) * std::tan(half) * std::log(std::tan(0.5 * half));
}

double moonRadiance(double phaseAngleDegrees, double distanceKm) {
  const double a = std::min(std::abs(phaseAngleDegrees), kThinnestDegrees);
  const double sine = kMoonRadiusKm / distanceKm;
  const double solidAngle = 2 * std::numbers::pi * sine * sine / (1 + std::sqrt(1 - sine * sine));
  return moonIlluminance(a, distanceKm) / (solidAngle * lommelSeeligerShare(a));
}

}  // namespace skydrop::sky
