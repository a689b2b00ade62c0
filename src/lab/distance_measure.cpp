#include "skydrop/lab/distance_measure.h"

#include <algorithm>
#include <cmath>

#include "lab/chapters.h"
#include "skydrop/lab/shared.h"

namespace skydrop::lab {
namespace {

namespace f32 = core::shared::f32;
namespace f64 = core::shared::f64;
using glm::dvec3;

constexpr int kPlaces = 2000;
constexpr double kGradientStep = 1e-6;

// Numbers in [0, 1) that fill a cube evenly (Roberts, "The Unreasonable Effectiveness of Quasirandom
// Sequences", 2018).
dvec3 evenly(int i) {
  constexpr double g = 1.2207440846057596;
  const auto part = [i](double step) { return std::fmod(0.5 + step * i, 1.0); };
  return {part(1 / g), part(1 / (g * g)), part(1 / (g * g * g))};
}

// Rays of a small picture from the usual place: visit(origin, direction).
template <class Visit>
void forRays(Visit visit) {
  const f64::Orbit eye = f64::make_orbit({0, 0.9, 0}, radians(30), radians(25), 5);
  constexpr int kAcross = 24, kDown = 16;
  for (int y = 0; y < kDown; ++y) {
    for (int x = 0; x < kAcross; ++x) {
      const glm::dvec2 at((2 * x + 1.0 - kAcross) / kDown, (2 * y + 1.0 - kDown) / kDown);
      visit(eye.place, f64::orbitRay(eye, at, 1.8));
    }
  }
}

}  // namespace

FootError footError(int scene, double amount) {
  FootError error;
  int count = 0;
  for (int i = 0; i < kPlaces; ++i) {
    const dvec3 place = (evenly(i) - 0.5) * dvec3(5, 0, 5) + dvec3(0, 0.05 + 2.4 * evenly(i).y, 0);
    const double distance = f64::sceneDistance(scene, amount, place);
    if (distance < 1e-2) continue;
    const dvec3 gradient = f64::differencesAt(scene, amount, place, kGradientStep);
    const double slope = glm::length(gradient);
    if (slope < 0.3) continue;  // beside a kink differences are no gradient
    const dvec3 foot = place - gradient * (distance / slope);
    const double left = f64::sceneDistance(scene, amount, foot) / distance;
    ++count;
    error.meanShort += std::max(left, 0.0);
    error.mostShort = std::max(error.mostShort, left);
    error.mostBeyond = std::max(error.mostBeyond, -left);
  }
  error.meanShort /= std::max(count, 1);
  return error;
}

double stepsPerRay(int scene, double amount) {
  double steps = 0;
  int rays = 0;
  forRays([&](const dvec3& origin, const dvec3& ray) {
    steps += f64::marchAlong(f64::kSphereTracing, scene, amount, origin, ray,
                             f64::make_marchLimits(1, 1e-3, 14), 1000)
                 .steps;
    ++rays;
  });
  return steps / rays;
}

NormalError normalError(double epsilon) {
  NormalError error;
  constexpr int kAround = 24, kAcross = 16;
  for (int i = 0; i < kAround * kAcross; ++i) {
    const double around = 2 * std::numbers::pi * (i / kAcross + 0.13) / kAround,
                 across = 2 * std::numbers::pi * (i % kAcross + 0.29) / kAcross;
    const double radius = 0.7 + 0.3 * std::cos(across);
    const dvec3 place(radius * std::cos(around), 0.3 * std::sin(across), radius * std::sin(around));
    const dvec3 exact = f64::torusGradient(place, 0.7);
    error.inDouble =
        std::max(error.inDouble, glm::length(f64::normalAt(f64::kTorusScene, 0, place, epsilon) - exact));
    const glm::vec3 inFloat =
        f32::normalAt(f32::kTorusScene, 0, glm::vec3(place), static_cast<float>(epsilon));
    error.inFloat = std::max(error.inFloat, glm::length(dvec3(inFloat) - exact));
  }
  return error;
}

ShadowError shadowError(const ShadowKnobs& knobs, double hardness) {
  ShadowError error;
  const dvec3 toSun =
      -f64::make_orbit({0, 0, 0}, radians(knobs.sunAzimuthDegrees), radians(knobs.sunElevationDegrees), 1)
           .ahead;
  constexpr int kSide = 60;
  for (int i = 0; i < kSide * kSide; ++i) {
    const dvec3 place(6 * (i % kSide + 0.5) / kSide - 3, 0, 6 * (i / kSide + 0.5) / kSide - 3);
    const f64::RaySpan box = f64::raySpanOfBox(place, toSun, {-1.2, 0, -1.2}, {1.2, 0.4, 1.2});
    const bool free = f64::rayToSphere(place, toSun, {0, 1.5, 0}, 0.6) < 0 && box.end <= box.begin;
    const f64::Shade shade = f64::shadeAlong(f64::kShadowScene, 0, place, toSun, knobs.start, 10, hardness,
                                             static_cast<int>(knobs.mostSteps));
    error.stepsPerRay += shade.steps;
    error.meanLight += shade.light;
    error.falseShade += free && shade.light <= 0 ? 1 : 0;
    error.falseLight += !free && shade.light > 0 ? 1 : 0;
  }
  for (double* sum : {&error.stepsPerRay, &error.meanLight, &error.falseShade, &error.falseLight})
    *sum /= kSide * kSide;
  return error;
}

OcclusionError occlusionError(const OcclusionKnobs& knobs) {
  OcclusionError error;
  int count = 0;
  double squares = 0;
  const int places = static_cast<int>(knobs.count);
  const double reach = knobs.stride * places;
  forRays([&](const dvec3& origin, const dvec3& ray) {
    const f64::March end = f64::marchAlong(f64::kSphereTracing, f64::kHolesScene, 0.5, origin, ray,
                                           f64::make_marchLimits(1, 1e-4, 9), 200);
    if (end.state != f64::kHit) return;
    const dvec3 place = origin + ray * end.t;
    const dvec3 normal = f64::normalAt(f64::kHolesScene, 0.5, place, 1e-5);
    const double open =
        f64::opennessAt(f64::kHolesScene, 0.5, place, normal, knobs.stride, places, knobs.intensity);
    const dvec3 side = glm::normalize(std::abs(normal.y) < 0.9 ? glm::cross(normal, dvec3(0, 1, 0))
                                                               : glm::cross(normal, dvec3(1, 0, 0)));
    const dvec3 other = glm::cross(normal, side);
    constexpr int kRays = 32;
    int free = 0;
    for (int i = 0; i < kRays; ++i) {
      const double radius = std::sqrt((i + 0.5) / kRays), angle = 2.399963229728653 * i;
      const dvec3 way = side * (radius * std::cos(angle)) + other * (radius * std::sin(angle)) +
                        normal * std::sqrt(1 - radius * radius);
      const f64::March blocked =
          f64::marchAlong(f64::kSphereTracing, f64::kHolesScene, 0.5, place + normal * 2e-3, way,
                          f64::make_marchLimits(1, 1e-3, reach), 64);
      free += blocked.state == f64::kHit ? 0 : 1;
    }
    const double reference = static_cast<double>(free) / kRays;
    error.meanOpenness += open;
    error.meanReference += reference;
    squares += (open - reference) * (open - reference);
    ++count;
  });
  error.meanOpenness /= std::max(count, 1);
  error.meanReference /= std::max(count, 1);
  error.rmsDifference = std::sqrt(squares / std::max(count, 1));
  return error;
}

}  // namespace skydrop::lab
