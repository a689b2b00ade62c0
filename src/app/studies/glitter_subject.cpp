#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <string_view>

#include "app/studies/subjects.h"
#include "app/studies/table_subject.h"
#include "skydrop/core/shared_glitter.h"

namespace skydrop::app {
namespace {

namespace f64 = core::shared::f64;
using glm::dvec3;

enum class GlitterMethod { integral, shared };
constexpr std::array<std::string_view, 2> kGlitterMethodNames = {"integral", "shared"};

struct GlitterParameters {
  GlitterMethod method = GlitterMethod::shared;
  std::int64_t rows = 8;
  double sunElevationDegrees = 10;
};

void describe(core::SettingsVisitor& visitor, GlitterParameters& p) {
  visitor.choice(
      "method", p.method, kGlitterMethodNames,
      {.help = "Facets of Cox and Munk's slopes, lit by parts of the disc, or the game's function."});
  visitor.integer("rows", p.rows,
                  {.unit = "1", .min = 1, .max = 4096, .help = "Of the disc, in the integral."});
  visitor.number("sunElevationDegrees", p.sunElevationDegrees,
                 {.unit = "degree", .min = -0.2, .max = 90, .help = "Above the horizon."});
}

constexpr double kDegree = std::numbers::pi / 180, kSlope = 0.14;                          // of the sea
constexpr std::array<double, 11> kElevations = {0.3, 1, 2, 3, 5, 10, 20, 30, 45, 60, 70};  // degrees, of eyes
constexpr std::array<double, 5> kAsides = {0, 2, 5, 10, 20};  // degrees, of azimuth

dvec3 towards(double elevationDegrees, double azimuthDegrees) {
  const double e = elevationDegrees * kDegree, a = azimuthDegrees * kDegree;
  return {std::cos(e) * std::cos(a), std::sin(e), std::cos(e) * std::sin(a)};
}

double fresnel(double incidence) {
  if (incidence < 1e-6) return 0.34 * 0.34 / (2.34 * 2.34);
  const double t = std::asin(std::sin(incidence) / 1.34);
  const double s = std::sin(incidence - t) / std::sin(incidence + t),
               p = std::tan(incidence - t) / std::tan(incidence + t);
  return (s * s + p * p) / 2;
}

// Of waves that hide each other (Smith 1967).
double hidden(double elevation) {
  const double nu = std::tan(elevation) / (std::numbers::sqrt2 * kSlope);
  return (std::exp(-nu * nu) / (nu * std::sqrt(std::numbers::pi)) - std::erfc(nu)) / 2;
}

// Radiance per illuminance across the rays of a light that is a point (Cox and Munk 1954).
double fromPoint(const dvec3& eye, const dvec3& light) {
  const dvec3 normal = glm::normalize(eye + light);
  const double x = normal.x / normal.y, z = normal.z / normal.y;
  const double slopes =
      std::exp(-(x * x + z * z) / (2 * kSlope * kSlope)) / (2 * std::numbers::pi * kSlope * kSlope);
  const double seenAndLit = 1 / (1 + hidden(std::asin(eye.y)) + hidden(std::asin(light.y)));
  return fresnel(std::acos(std::min(glm::dot(normal, eye), 1.0))) * slopes * seenAndLit /
         (4 * eye.y * std::pow(normal.y, 4));
}

// The mean over the part of the disc that is above the horizon: so many rows of a fifth as many places.
double byIntegral(const dvec3& eye, const GlitterParameters& p) {
  const std::int64_t columns = std::max<std::int64_t>(p.rows / 5, 1);
  const double radius = f64::kSunRadius;
  double sum = 0, weight = 0;
  for (std::int64_t i = 0; i < p.rows; ++i) {
    const double v = -1 + (static_cast<double>(i) + 0.5) * 2 / static_cast<double>(p.rows);
    const double height = p.sunElevationDegrees * kDegree + v * radius, half = std::sqrt(1 - v * v);
    if (height <= 0) continue;
    for (std::int64_t j = 0; j < columns; ++j) {
      const double u = half * (-1 + (static_cast<double>(j) + 0.5) * 2 / static_cast<double>(columns));
      sum += half * fromPoint(eye, towards(height / kDegree, 180 + u * radius / kDegree));
      weight += half;
    }
  }
  return weight > 0 ? sum / weight : 0;
}

class GlitterSubject final : public TableSubject<GlitterParameters> {
  static std::vector<double> radiances(const GlitterParameters& p) {
    std::vector<double> values;
    for (const double elevation : kElevations) {
      for (const double aside : kAsides) {
        const dvec3 eye = towards(elevation, aside);
        values.push_back(p.method == GlitterMethod::integral
                             ? byIntegral(eye, p)
                             : f64::sunGlitter(eye, towards(p.sunElevationDegrees, 180), f64::kSunRadius,
                                               {0, 0}, kSlope, kSlope));
      }
    }
    return values;
  }
  accuracy::Observation compute(const GlitterParameters& p) override {
    accuracy::Observation observation;
    observation.values = radiances(p);
    return observation;
  }
  double work(const GlitterParameters& p) override { return radiances(p).back(); }
};

}  // namespace

std::unique_ptr<accuracy::Subject> makeGlitterSubject() { return std::make_unique<GlitterSubject>(); }

}  // namespace skydrop::app
