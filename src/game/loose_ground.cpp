#include <algorithm>
#include <cmath>

#include "skydrop/core/deterministic_math.h"
#include "skydrop/core/shared_woods.h"
#include "skydrop/game/surface_burst.h"
#include "skydrop/terrain/chunk_grid.h"
#include "skydrop/terrain/strips.h"

namespace skydrop::game {
namespace {

namespace shared = core::shared::f64;

constexpr double kFarthestM = 1e12;

// Looseness is of the order of silt contents and cover: what a wheel lifts from dry sand is 1. Albedos are
// those of landSurface(), soil's under grass that of dry loam (0.1 to 0.2).
const LooseGround kSoil{0.3, {0.165, 0.134, 0.096}}, kSand{1, {0.350, 0.290, 0.195}},
    kLitter{0.35, {0.095, 0.072, 0.045}}, kScree{0.5, {0.170, 0.157, 0.140}},
    kRock{0.2, {0.160, 0.146, 0.128}}, kSnow{0.9, {0.760, 0.790, 0.830}}, kTurf{0.25, {0.165, 0.134, 0.096}},
    kWornTurf{0.7, {0.190, 0.155, 0.112}};
// Of a strip that is worn bare, from its ends, m (shaders/shared/grass_strip.glsl).
constexpr double kWornFromM = 40, kWornToM = 170;

void add(LooseGround& sum, const LooseGround& part, double share) {
  sum.looseness += part.looseness * share;
  sum.albedo += part.albedo * share;
}

}  // namespace

LooseGround looseGroundAt(const terrain::HeightSource& ground, const glm::dvec3& position, bool alpineBelts) {
  const glm::dvec2 xz(position.x, position.z);
  if (!(std::abs(xz.x) < kFarthestM && std::abs(xz.y) < kFarthestM)) return {};
  if (const terrain::Strips* strips = ground.strips()) {
    if (const auto strip = strips->at(xz)) {
      const double fromEnd = strip->halfLength - std::abs(strip->local(xz).x);
      return fromEnd > kWornFromM && fromEnd < kWornToM ? kWornTurf : kTurf;
    }
  }
  const terrain::HeightSample land = ground.sample(xz);
  const double height = alpineBelts ? std::min(land.height, 0.0) + 0.3335 * std::max(land.height, 0.0) +
                                          26.66 * (1 - core::dmath::exp(-std::max(land.height, 0.0) / 40))
                                    : land.height;
  const glm::dvec2 chunk = glm::floor(xz / terrain::kChunkMetres);
  const shared::Uvec2 wrapped(
      static_cast<std::uint32_t>(terrain::wrappedIndex(static_cast<std::int64_t>(chunk.x))),
      static_cast<std::uint32_t>(terrain::wrappedIndex(static_cast<std::int64_t>(chunk.y))));
  const shared::LandNoise noise = shared::woodNoise(wrapped, xz - chunk * terrain::kChunkMetres);
  const shared::LandSurface surface =
      shared::landSurface(height, terrain::normalOf(land).y, 0, noise, 0, {{0, 0}, 0, 0}, 0);
  LooseGround sum;
  add(sum, kSand, surface.sand), add(sum, kLitter, surface.litter), add(sum, kScree, surface.scree);
  add(sum, kRock, surface.rock), add(sum, kSnow, surface.snow);
  add(sum, kSoil, 1 - surface.sand - surface.litter - surface.scree - surface.rock - surface.snow);
  return sum;
}

}  // namespace skydrop::game
