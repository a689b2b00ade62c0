#include "game/targets.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "skydrop/core/deterministic_math.h"
#include "skydrop/core/guards.h"

namespace skydrop::game {
namespace {

namespace dmath = core::dmath;

constexpr int kDrawsPerRing = 64;
constexpr int kRings = 10;
constexpr double kRingGrowth = 1.5;
// The centre stands this high above the sea, and so much of the radius around it is land, m and 1.
constexpr double kShore = 2;
constexpr double kDryShare = 0.7;

bool fits(const terrain::HeightSource& ground, const glm::dvec2& at, const GameSettings& settings,
          double steepest) {
  const terrain::HeightSample centre = ground.sample(at);
  if (centre.height < kShore || glm::length(centre.gradient) > steepest) return false;
  constexpr double d = 0.70710678118654752;
  for (const glm::dvec2& way :
       {glm::dvec2{1, 0}, {d, d}, {0, 1}, {-d, d}, {-1, 0}, {-d, -d}, {0, -1}, {d, -d}}) {
    if (ground.height(at + way * (kDryShare * settings.targetRadius)) <= 0) return false;
  }
  return true;
}

}  // namespace

std::optional<glm::dvec3> drawTarget(const terrain::HeightSource& ground, const glm::dvec3& around,
                                     const GameSettings& settings, core::RandomStream& random) {
  const double steepest = dmath::tan(settings.targetSlopeDeg * dmath::kRadPerDeg);
  const double nearest = std::min(settings.targetNearest, settings.targetFarthest);
  double farthest = std::max(settings.targetNearest, settings.targetFarthest);
  for (int ring = 0; ring < kRings; ++ring, farthest *= kRingGrowth) {
    if (ring > 0) core::countGuard(core::Guard::targetWidened);
    for (int draw = 0; draw < kDrawsPerRing; ++draw) {
      const double share = random.nextUnit(), turn = random.nextUnit() * dmath::kTwoPi;
      const double distance =
          std::sqrt(nearest * nearest + share * (farthest * farthest - nearest * nearest));
      const glm::dvec2 at =
          glm::dvec2(around.x, around.z) + distance * glm::dvec2(dmath::cos(turn), dmath::sin(turn));
      if (fits(ground, at, settings, steepest)) return glm::dvec3(at.x, ground.height(at), at.y);
    }
  }
  return {};
}

}  // namespace skydrop::game
