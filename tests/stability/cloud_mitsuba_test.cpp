// The path tracer of clouds against another one, on a grid that both have:
// noise_scripts/cloud_mitsuba.py.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "skydrop/clouds/path_tracer.h"
#include "skydrop/core/hash.h"
#include "support/instrumented.h"

namespace skydrop::clouds {
namespace {

constexpr int kSide = 16;
constexpr double kBoxM = 1000, kExtinction = 0.04;

// As the script has it.
double densityOf(int x, int y, int z) {
  const double bump = (3 * x * (15 - x) + 5 * y * (15 - y) + 4 * z * (15 - z)) / 675.0;
  const double hole = ((x * 7 + y * 3 + z * 5) % 4) / 3.0;
  return bump * (0.4 + 0.6 * hole);
}

double extinctionAt(const glm::dvec3& place) {
  const glm::dvec3 voxel = glm::floor(place / kBoxM * double{kSide});
  for (int axis = 0; axis < 3; ++axis) {
    if (voxel[axis] < 0 || voxel[axis] >= kSide) return 0;
  }
  return kExtinction *
         densityOf(static_cast<int>(voxel.x), static_cast<int>(voxel.y), static_cast<int>(voxel.z));
}

// Mean radiance of the script's picture: rays anywhere in it.
TracedPixel meanOfPicture(const TracedPhase& phase) {
  const TracedMedium medium{
      extinctionAt, 0, kBoxM,
      std::make_shared<const ExtinctionBounds>([](const glm::dvec3&) { return kExtinction; }, 0, kBoxM,
                                               8 * kBoxM, kBoxM, kBoxM)};
  const glm::dvec3 toSun(0.48, 0.6, 0.64), eye(-1500, 200, 900),
      forward = glm::normalize(glm::dvec3(kBoxM / 2) - eye),
      right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0))), up = glm::cross(right, forward);
  const double half = std::tan(glm::radians(35.0 / 2));
  double sum = 0, squares = 0;
  const int paths = test::repetitions(200000);
  for (int i = 0; i < paths; ++i) {
    core::RandomStream random{core::hashCombine(23, static_cast<std::uint64_t>(i)), 0};
    const double x = 2 * random.nextUnit() - 1, y = 2 * random.nextUnit() - 1;
    const MarchRay ray{eye, glm::normalize(forward + half * (x * right + y * up))};
    const double sun = tracePath(medium, phase, toSun, ray, random).sun;
    sum += sun;
    squares += sun * sun;
  }
  TracedPixel mean;
  mean.mean.sun = sum / paths;
  mean.error.sun = std::sqrt((squares / paths - mean.mean.sun * mean.mean.sun) / paths);
  return mean;
}

// What the script printed with 4096 paths a pixel (Mitsuba 3.9.1), with its
// standard error.
struct Printed {
  TracedPhase phase;
  double mean, error;
};
constexpr Printed kPrinted[] = {{{0, 0, 0, 1}, 0.032966, 0.000150},
                                {{0.3, 0, 0, 1}, 0.043164, 0.000149},
                                {{0.119, 0.15, 0.85, 1}, 0.038537, 0.000207}};

TEST(CloudPathTracer, anotherPathTracerFindsTheSameMeans) {
  // Within three standard errors of both, and those are small enough to tell 2 %.
  for (const Printed& printed : kPrinted) {
    const TracedPixel ours = meanOfPicture(printed.phase);
    const double error = std::hypot(ours.error.sun, printed.error);
    EXPECT_NEAR(ours.mean.sun, printed.mean, 3 * error) << ours.mean.sun << " +- " << ours.error.sun;
    if (test::kInstrumented) continue;
    EXPECT_LT(error, 0.02 * printed.mean);
  }
}

}  // namespace
}  // namespace skydrop::clouds
