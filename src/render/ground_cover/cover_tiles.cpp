#include "render/ground_cover/cover_tiles.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "render/frame/visibility.h"

namespace skydrop::render {
namespace {

namespace shared = core::shared::f64;

constexpr double kSteepest = 1.75;  // of the land from a square's middle, m a metre

double tileM(std::size_t level) { return kCoverTileCells * shared::coverCellM(static_cast<int>(level)); }

struct Tile {
  glm::ivec4 corner{0};
  double awayM = 0;
};

}  // namespace

CoverReaches coverReaches(double reachM, double density) {
  CoverReaches reaches{};
  for (std::size_t level = 0; level < kCoverLevels; ++level)
    reaches[level] = shared::coverReach(static_cast<int>(level), reachM, density);
  return reaches;
}

std::size_t mostCoverTiles(const CoverReaches& reaches) {
  double most = 0;
  for (std::size_t level = 0; level < kCoverLevels; ++level) {
    // Squares that a disc touches lie within one that is wider by their diagonal.
    const double radius = (reaches[level] + shared::kWidestCoverM) / tileM(level) + std::numbers::sqrt2;
    most += std::numbers::pi * radius * radius;
  }
  return static_cast<std::size_t>(most) + 1;
}

std::vector<glm::ivec4> coverTiles(const View& view, const glm::dvec2& base,
                                   const terrain::HeightSource& ground, const CoverReaches& reaches) {
  const glm::dvec2 eye = glm::dvec2(view.position.x, view.position.z) - base;
  std::vector<glm::ivec4> tiles;
  std::vector<Tile> seen;
  for (std::size_t level = 0; level < kCoverLevels; ++level) {
    const double side = tileM(level), reach = reaches[level];
    if (reach <= 0) continue;
    seen.clear();
    const glm::ivec2 first(glm::floor((eye - reach) / side)), last(glm::floor((eye + reach) / side));
    const double half = side / std::numbers::sqrt2;  // from its middle to its corners
    const double around = half * std::hypot(1.0, kSteepest) + shared::kTallestCoverM;
    for (int z = first.y; z <= last.y; ++z) {
      for (int x = first.x; x <= last.x; ++x) {
        const glm::dvec2 corner = glm::dvec2(x, z) * side - eye;
        const glm::dvec2 nearest = glm::clamp(glm::dvec2(0), corner, corner + side);
        if (glm::length(nearest) > reach) continue;
        const glm::dvec2 middle = corner + side / 2;
        const double height = ground.height(base + eye + middle);
        const glm::dvec3 place(middle.x, height - view.position.y, middle.y);
        const double away = glm::length(place);
        if (away - around > reach || height + around < -1) continue;
        if (!isPotentiallyVisible(view, view.position + place, around)) continue;
        seen.push_back({{glm::ivec2(x, z) * kCoverTileCells, static_cast<int>(level), 0}, away});
      }
    }
    std::ranges::stable_sort(seen, {}, &Tile::awayM);
    for (const Tile& tile : seen) tiles.push_back(tile.corner);
  }
  return tiles;
}

}  // namespace skydrop::render
