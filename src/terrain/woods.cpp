#include "skydrop/terrain/woods.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "skydrop/core/deterministic_math.h"
#include "skydrop/terrain/chunk_grid.h"
#include "skydrop/terrain/places.h"

namespace skydrop::terrain {
namespace {

namespace shared = core::shared::f64;

constexpr double kWidestQueryM = 1000;
constexpr double kFarthestM = 1e12;  // where doubles still resolve a tenth of a millimetre
constexpr double kStripReachM = 2500;

bool isInReach(const glm::dvec2& xz) { return std::abs(xz.x) < kFarthestM && std::abs(xz.y) < kFarthestM; }

// shared::alpineBeltHeight with a deterministic exponential.
double alpineHeight(double heightM) {
  const double land = std::max(heightM, 0.0);
  return std::min(heightM, 0.0) + 0.3335 * land + 26.66 * (1 - core::dmath::exp(-land / 40));
}

// The chunk of level 0 that a cell of the lattice lies in.
std::int64_t chunkOf(std::int64_t cell) {
  return cell >= 0 ? cell / shared::kTreeCellsPerChunk
                   : -((-cell + shared::kTreeCellsPerChunk - 1) / shared::kTreeCellsPerChunk);
}

shared::Uvec2 wrapped(std::int64_t chunkX, std::int64_t chunkZ) {
  return {static_cast<std::uint32_t>(wrappedIndex(chunkX)), static_cast<std::uint32_t>(wrappedIndex(chunkZ))};
}

bool isCleared(const glm::dvec2& xz, std::span<const Strip> clearings) {
  return std::ranges::any_of(clearings, [&](const Strip& strip) {
    const glm::dvec2 at = strip.local(xz);
    return std::abs(at.x) < strip.halfLength + kClearBeforeStripM &&
           std::abs(at.y) < strip.halfWidth + kClearBesideStripM;
  });
}

double distanceTo(const StandingTree& tree, const glm::dvec3& point) {
  const glm::dvec3 from = point - tree.foot;
  const double away = std::sqrt(from.x * from.x + from.z * from.z);
  const double up = std::clamp(from.y, 0.0, tree.shape.heightM);
  const double aside = std::max(away - shared::treeWidthAt(tree.shape, up), 0.0);
  const double over = from.y - up;
  return std::sqrt(aside * aside + over * over);
}

}  // namespace

void describe(core::SettingsVisitor& v, WoodsSettings& s) {
  v.number("density", s.density,
           {.unit = "1",
            .min = 0,
            .max = 1,
            .help = "Share of the trees of the woods that stand.",
            .aliases = "trees, forest, vegetation"});
  v.flag("obstacles", s.obstacles,
         {.help = "A tree that the aircraft touches ends the flight.", .aliases = "collision, trees, crash"});
}

double forestShare(const HeightSample& land, const glm::dvec2& xz, bool alpineBelts) {
  if (!isInReach(xz)) return 0;
  const glm::dvec2 chunk = glm::floor(xz / kChunkMetres);
  const shared::LandNoise noise =
      shared::woodNoise(wrapped(static_cast<std::int64_t>(chunk.x), static_cast<std::int64_t>(chunk.y)),
                        xz - chunk * kChunkMetres);
  return shared::forestDensity(alpineBelts ? alpineHeight(land.height) : land.height, normalOf(land).y, 0,
                               noise);
}

struct Woods::Cells {
  std::int64_t firstX = 0, lastX = -1, firstZ = 0, lastZ = -1;
};

Woods::Woods(std::shared_ptr<const HeightSource> ground, double density, bool alpineBelts,
             std::shared_ptr<const Places> places)
    : ground_(std::move(ground)), density_(density), alpineBelts_(alpineBelts), places_(std::move(places)) {}

Woods::Cells Woods::cellsAround(const glm::dvec2& xz, double radiusM) const {
  const auto cell = [](double metres) {
    return static_cast<std::int64_t>(std::floor(metres / shared::kTreeCellM));
  };
  const double reach = radiusM + shared::kStemReachM;
  return {cell(xz.x - reach), cell(xz.x + reach), cell(xz.y - reach), cell(xz.y + reach)};
}

std::vector<Strip> Woods::clearings(const glm::dvec2& xz, double radiusM) const {
  std::vector<Strip> found;
  const Strips* strips = ground_->strips();
  if (!strips || !isInReach(xz)) return found;
  // At most one to a square of kStripCell: the nearest of nine places (of one, for a point) has all that are
  // near.
  const int aside = radiusM > 0 ? 1 : 0;
  for (int dz = -aside; dz <= aside; ++dz) {
    for (int dx = -aside; dx <= aside; ++dx) {
      const auto strip = strips->nearest(xz + glm::dvec2(dx, dz) * radiusM, radiusM + kStripReachM);
      if (strip && std::ranges::none_of(found, [&](const Strip& s) { return s.middle == strip->middle; }))
        found.push_back(*strip);
    }
  }
  return found;
}

std::optional<StandingTree> Woods::standing(std::int64_t cellX, std::int64_t cellZ,
                                            std::span<const Strip> clearings,
                                            const PlacesAround& settled) const {
  const std::int64_t chunkX = chunkOf(cellX), chunkZ = chunkOf(cellZ);
  const shared::Uvec2 chunk = wrapped(chunkX, chunkZ);
  const glm::dvec2 local(static_cast<double>(cellX - chunkX * shared::kTreeCellsPerChunk),
                         static_cast<double>(cellZ - chunkZ * shared::kTreeCellsPerChunk));
  const auto perChunk = static_cast<std::uint32_t>(shared::kTreeCellsPerChunk);
  const shared::Uint bits =
      shared::treeBits(chunk * perChunk + shared::Uvec2(static_cast<std::uint32_t>(local.x),
                                                        static_cast<std::uint32_t>(local.y)));
  const glm::dvec2 inside = local * shared::kTreeCellM + shared::treeStem(bits);
  const glm::dvec2 xz =
      glm::dvec2(static_cast<double>(chunkX), static_cast<double>(chunkZ)) * kChunkMetres + inside;
  const shared::LandNoise noise = shared::woodNoise(chunk, inside);
  // The best place for a tree: what does not stand there stands nowhere.
  if (shared::treeOf(bits, 200, 1, noise, density_).heightM <= 0) return {};
  const HeightSample land = ground_->sample(xz);
  const double height = alpineBelts_ ? alpineHeight(land.height) : land.height;
  const shared::Tree tree = shared::treeOf(bits, height, normalOf(land).y, noise, density_);
  if (tree.heightM <= 0 || isCleared(xz, clearings) || settled.isSettled(xz)) return {};
  return StandingTree{{xz.x, land.height, xz.y}, tree};
}

std::vector<StandingTree> Woods::around(const glm::dvec2& xz, double radiusM) const {
  std::vector<StandingTree> found;
  if (!isInReach(xz) || !(radiusM >= 0) || density_ <= 0) return found;
  radiusM = std::min(radiusM, kWidestQueryM);
  const std::vector<Strip> strips = clearings(xz, radiusM);
  const PlacesAround settled = places_ ? places_->around(xz, radiusM) : PlacesAround{};
  const Cells cells = cellsAround(xz, radiusM);
  for (std::int64_t z = cells.firstZ; z <= cells.lastZ; ++z) {
    for (std::int64_t x = cells.firstX; x <= cells.lastX; ++x) {
      const auto tree = standing(x, z, strips, settled);
      if (!tree) continue;
      const double dx = tree->foot.x - xz.x, dz = tree->foot.z - xz.y;
      if (dx * dx + dz * dz <= radiusM * radiusM) found.push_back(*tree);
    }
  }
  return found;
}

std::optional<StandingTree> Woods::touching(std::span<const glm::dvec3> points, double reachM) const {
  if (points.empty() || density_ <= 0) return {};
  const glm::dvec2 xz(points[0].x, points[0].z);
  if (!isInReach(xz)) return {};
  double lowest = points[0].y, widest = 0;
  for (const glm::dvec3& point : points) {
    lowest = std::min(lowest, point.y);
    const double dx = point.x - xz.x, dz = point.z - xz.y;
    widest = std::max(widest, std::sqrt(dx * dx + dz * dz));
  }
  // Ground next to it may be higher: as steep as woods grow, and some.
  const double reach = widest + reachM + shared::kWidestCrownM;
  if (lowest - ground_->height(xz) > kTallestTreeM + reachM + 1.2 * reach) return {};
  const std::vector<Strip> strips = clearings(xz, 0);
  const PlacesAround settled = places_ ? places_->around(xz, reach) : PlacesAround{};
  const Cells cells = cellsAround(xz, reach);
  for (std::int64_t z = cells.firstZ; z <= cells.lastZ; ++z) {
    for (std::int64_t x = cells.firstX; x <= cells.lastX; ++x) {
      const auto tree = standing(x, z, strips, settled);
      if (!tree) continue;
      const bool touches = std::ranges::any_of(
          points, [&](const glm::dvec3& point) { return distanceTo(*tree, point) < reachM; });
      if (touches) return tree;
    }
  }
  return {};
}

}  // namespace skydrop::terrain
