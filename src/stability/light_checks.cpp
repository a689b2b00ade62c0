#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <numbers>

#include "skydrop/core/shared.h"
#include "skydrop/core/shared_ice.h"
#include "stability/checks.h"

namespace skydrop::stability {
namespace {

namespace f32 = core::shared::f32;
namespace f64 = core::shared::f64;

constexpr double kTau = 2 * std::numbers::pi;
constexpr int kSteps = 200000;  // of an integral over the cosine: 1e-5 for g up to 0.95

double cosineAt(int step) { return -1 + 2 * (step + 0.5) / kSteps; }

// Over all directions within 8.6 degrees of the horizon, from 0 to 10 km up, to 60 km.
template <class See>
void forEachBentRay(const See& see) {
  for (const double eyeM : {0.0, 900.0, 4600.0, 10000.0}) {
    for (double sine = -0.15; sine <= 0.15; sine += 0.005) {
      const double level = std::sqrt(1 - sine * sine);
      const glm::dvec3 direction(level * std::cos(0.7), sine, level * std::sin(0.7));
      for (double t = 500; t <= 60000; t += 500) {
        const double onSphere =
            std::hypot(t * level, f64::kEarthRadiusM + eyeM + t * sine) - f64::kEarthRadiusM;
        if (onSphere < 0 || onSphere > 12000) continue;  // where there are no clouds
        const double bent = eyeM + f64::placeOnBentRay(direction, f64::rayBend(direction), t).y;
        see(eyeM, direction, t, bent, onSphere);
      }
    }
  }
}

template <class Error>
double worstOfSteps(const Error& error) {
  double worst = 0;
  for (int i = 0; i <= 130000; ++i) {
    const auto depth = static_cast<float>(std::pow(10.0, -9 + i * 1e-4));
    worst = std::max(worst, std::abs(error(depth) / -std::expm1(-static_cast<double>(depth)) - 1));
  }
  return worst;
}

}  // namespace

double phaseIntegralError() {
  double worst = 0;
  for (const double g : {-0.9, 0.0, 0.5, 0.76, 0.95, 1.0}) {
    double sum = 0, mean = 0;
    for (int i = 0; i < kSteps; ++i) {
      const double part = f64::henyeyGreenstein(cosineAt(i), g) * kTau * 2 / kSteps;
      sum += part;
      mean += part * cosineAt(i);
    }
    worst = std::max({worst, std::abs(sum - 1), std::abs(mean - std::min(g, 0.95))});
  }
  return worst;
}

double rayleighIntegralError() {
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) sum += f64::rayleighPhase(cosineAt(i)) * kTau * 2 / kSteps;
  return std::abs(sum - 1);
}

// The closed form is (1 + g) / (1 - g)^2 / 4 pi ahead and (1 - g) / (1 + g)^2 / 4 pi back.
double phaseEndsErrorInFloat() {
  double worst = 0;
  for (const double g : {0.1, 0.76, 0.9, 0.95}) {
    for (const double side : {1.0, -1.0}) {
      const double exact = (1 + side * g) / ((1 - side * g) * (1 - side * g)) / (2 * kTau);
      const double found = f32::henyeyGreenstein(static_cast<float>(side), static_cast<float>(g));
      worst = std::max(worst, std::abs(found / exact - 1));
    }
  }
  return worst;
}

double icePhaseIntegralError() {
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) sum += f64::icePhase(cosineAt(i)) * kTau * 2 / kSteps;
  return std::abs(sum - 1);
}

double stepOpacityError() {
  return worstOfSteps([](float depth) { return f64::stepOpacity(depth); });
}

double stepOpacityErrorInFloat() {
  return worstOfSteps([](float depth) { return static_cast<double>(f32::stepOpacity(depth)); });
}

double depthRoundTripError() {
  double worst = 0;
  for (double distance = 1; distance <= 1e7; distance *= 1.3) {
    for (const double rayScale : {1.0, 1.53}) {
      const float depth = f32::depthOfViewZ(static_cast<float>(distance / rayScale), 0.1f);
      const double back = f32::distanceOfDepth(depth, 0.1f, static_cast<float>(rayScale));
      worst = std::max(worst, std::abs(back / distance - 1));
    }
  }
  return worst;
}

double bentRayHeightError() {
  double worst = 0;
  forEachBentRay([&](double, const glm::dvec3&, double, double bent, double onSphere) {
    worst = std::max(worst, std::abs(bent - onSphere));
  });
  return worst;
}

double bentRayFloatError() {
  double worst = 0;
  forEachBentRay([&](double eyeM, const glm::dvec3& direction, double t, double bent, double) {
    const f32::Vec3 inFloat(direction);
    const float found = f32::placeOnBentRay(inFloat, f32::rayBend(inFloat), static_cast<float>(t)).y;
    worst = std::max(worst, std::abs(found + eyeM - bent));
  });
  return worst;
}

double levelFogPathErrorInFloat() {
  double worst = 0;
  for (const double from : {-30.0, 0.0, 1.0, 90.0}) {
    const double exact = 5000 * std::exp(-std::max(from, 0.0) / 40);
    for (const double rise : {0.0, 1e-40, -1e-40, 1e-20, -1e-20, 1e-4, -1e-4}) {
      const double path = f32::groundFogPath(static_cast<float>(from), static_cast<float>(rise), 5000, 40);
      worst = std::max(worst, std::abs(path / exact - 1));
    }
  }
  return worst;
}

}  // namespace skydrop::stability
