#include "render/vegetation/tree_tiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "skydrop/core/shared_woods.h"

namespace skydrop::render {
namespace {

namespace shared = core::shared::f64;

constexpr double kSteepest = 1;  // of the land between the eye's foot and a tile, m a metre
constexpr double kAroundM = 8;   // what a tree reaches beyond its tile

using Planes = std::array<glm::dvec4, 5>;

// Of what is in view, relative to the eye: inside where all are positive.
Planes planesOf(const View& view) {
  const glm::dmat4 m(viewProjection(view));
  const auto row = [&](int i) { return glm::dvec4(m[0][i], m[1][i], m[2][i], m[3][i]); };
  return {row(3) + row(0), row(3) - row(0), row(3) + row(1), row(3) - row(1), row(3)};
}

bool mayBeSeen(const Planes& planes, const glm::dvec3& lo, const glm::dvec3& hi) {
  return std::ranges::all_of(planes, [&](const glm::dvec4& p) {
    const glm::dvec3 farthest(p.x > 0 ? hi.x : lo.x, p.y > 0 ? hi.y : lo.y, p.z > 0 ? hi.z : lo.z);
    return glm::dot(glm::dvec3(p), farthest) + p.w > 0;
  });
}

}  // namespace

TreeTiles treeTiles(const View& view, const glm::dvec2& base, const terrain::HeightSource& ground,
                    double meshM, double reachM) {
  struct Tile {
    glm::ivec2 corner{0};
    double awayM = 0;
  };
  std::vector<Tile> seen;
  const Planes planes = planesOf(view);
  const glm::dvec2 eye = glm::dvec2(view.position.x, view.position.z) - base;
  const double foot = ground.height({view.position.x, view.position.z});
  const terrain::HeightBounds all = ground.range();
  const glm::ivec2 first(glm::floor((eye - reachM) / kTileM)), last(glm::floor((eye + reachM) / kTileM));
  for (int z = first.y; z <= last.y; ++z) {
    for (int x = first.x; x <= last.x; ++x) {
      const glm::dvec2 corner = glm::dvec2(x, z) * kTileM - eye;
      const glm::dvec2 nearest = glm::clamp(glm::dvec2(0), corner, corner + kTileM);
      const double away = glm::length(nearest);
      if (away > reachM) continue;
      const double slack = kSteepest * (away + 1.5 * kTileM) + 10;
      const double low = std::max(foot - slack, all.lowest), high = std::min(foot + slack, all.highest);
      if (high <= 0) continue;  // the sea
      const glm::dvec3 lo(corner.x - kAroundM, low - view.position.y, corner.y - kAroundM);
      const glm::dvec3 hi(corner.x + kTileM + kAroundM, high + shared::kTallestTreeM - view.position.y,
                          corner.y + kTileM + kAroundM);
      if (mayBeSeen(planes, lo, hi)) seen.push_back({glm::ivec2(x, z) * kTileCells, away});
    }
  }
  std::ranges::stable_sort(seen, {}, &Tile::awayM);
  TreeTiles tiles;
  for (const Tile& tile : seen) {
    tiles.corners.push_back(tile.corner);
    if (tile.awayM < meshM) ++tiles.near;
  }
  return tiles;
}

}  // namespace skydrop::render
