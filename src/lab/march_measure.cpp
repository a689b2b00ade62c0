#include "skydrop/lab/march_measure.h"

#include <algorithm>
#include <cmath>

#include "lab/chapters.h"

namespace skydrop::lab {
namespace {

namespace f32 = core::shared::f32;
namespace f64 = core::shared::f64;

constexpr int kAcross = 32, kDown = 18;
constexpr double kZoom = 1.8;  // as in shaders/lab/march.glsl

struct End {
  double t;
  int steps;
  bool hit;
};

template <class March>
MarchError errorOver(const MarchKnobs& knobs, March march) {
  const f64::Orbit orbit = f64::make_orbit({0, 1, 0}, radians(knobs.view.azimuthDegrees),
                                           radians(knobs.view.elevationDegrees), knobs.view.distance);
  MarchError error;
  int right = 0, wrong = 0;
  double steps = 0, sum = 0;
  for (int y = 0; y < kDown; ++y) {
    for (int x = 0; x < kAcross; ++x) {
      const glm::dvec2 at((2 * x + 1.0 - kAcross) / kDown, (2 * y + 1.0 - kDown) / kDown);
      const glm::dvec3 ray = f64::orbitRay(orbit, at, kZoom);
      const double exact = f64::rayToBallScene(orbit.place, ray);
      const End end = march(orbit.place, ray);
      steps += end.steps;
      const bool there = exact >= 0 && exact <= knobs.reach;
      if (there != end.hit) {
        ++wrong;
      } else if (there) {
        ++right;
        sum += std::abs(end.t - exact);
        error.largestError = std::max(error.largestError, std::abs(end.t - exact));
      }
    }
  }
  error.stepsPerRay = steps / (kAcross * kDown);
  error.meanError = right > 0 ? sum / right : 0;
  error.wrongShare = static_cast<double>(wrong) / (kAcross * kDown);
  return error;
}

}  // namespace

MarchError marchError(const MarchKnobs& knobs, int method) {
  const f64::MarchLimits limits = f64::make_marchLimits(knobs.stride, knobs.tolerance, knobs.reach);
  return errorOver(knobs, [&](const glm::dvec3& origin, const glm::dvec3& ray) {
    const f64::March end =
        f64::marchAlong(method, f64::kBallScene, 0, origin, ray, limits, static_cast<int>(knobs.mostSteps));
    return End{end.t, end.steps, end.state == f64::kHit};
  });
}

MarchError marchErrorInFloat(const MarchKnobs& knobs, int method) {
  const f32::MarchLimits limits = f32::make_marchLimits(
      static_cast<float>(knobs.stride), static_cast<float>(knobs.tolerance), static_cast<float>(knobs.reach));
  return errorOver(knobs, [&](const glm::dvec3& origin, const glm::dvec3& ray) {
    const f32::March end = f32::marchAlong(method, f32::kBallScene, 0, glm::vec3(origin), glm::vec3(ray),
                                           limits, static_cast<int>(knobs.mostSteps));
    return End{end.t, end.steps, end.state == f32::kHit};
  });
}

}  // namespace skydrop::lab
