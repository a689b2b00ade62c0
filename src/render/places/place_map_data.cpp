#include "render/places/place_map_data.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace skydrop::render {
namespace {

namespace shared = core::shared::f64;

constexpr double kFieldReachM = 8 * shared::kFieldBlockM + 60;  // from a village's middle, and half a square
constexpr double kWayReachM = 9, kShadowReachM = 22;
constexpr double kHalfDiagonalM = 23;  // of a square
constexpr std::uint32_t kMostInSquare = 255;

std::uint32_t bitsOf(double value) { return std::bit_cast<std::uint32_t>(static_cast<float>(value)); }

class Packer {
 public:
  explicit Packer(const glm::dvec2& corner) {
    made_.corner = corner;
    made_.grid.resize(static_cast<std::size_t>(kPlaceGridSide * kPlaceGridSide));
    made_.data.resize(static_cast<std::size_t>(kPlaceRow * kPlaceRows));
    pieces_.resize(made_.grid.size());
    houses_.resize(made_.grid.size());
    nearest_.assign(made_.grid.size(), 1e9);
  }

  void add(const terrain::Village& village) {
    if (made_.villages.size() == kMostVillages) return;
    const glm::dvec2 middle = village.middle - made_.corner;
    std::size_t at = kVillageTexels * made_.villages.size();
    made_.villages.push_back(village.middle);
    made_.data[at++] = {bitsOf(middle.x), bitsOf(middle.y), bitsOf(village.along.x), bitsOf(village.along.y)};
    made_.data[at++] = {village.bits, 0, 0, 0};
    for (std::size_t row = 0; row < village.blocks.size(); row += 4)
      made_.data[at++] = {village.blocks[row], village.blocks[row + 1], village.blocks[row + 2],
                          village.blocks[row + 3]};
    forSquares(middle, middle, kFieldReachM, [&](std::size_t square, const glm::dvec2& place) {
      const double away = glm::distance(place, middle);
      if (away > kFieldReachM || away > nearest_[square]) return;
      nearest_[square] = away;
      made_.grid[square][0] = static_cast<std::uint32_t>(made_.villages.size()) << 24;
    });
    for (const terrain::WayPiece& piece : village.ways) add(piece);
    for (const terrain::HousePart& part : village.parts) add(part);
  }

  void add(const terrain::WayPiece& piece) {
    const glm::dvec2 from = piece.from - made_.corner, to = piece.to - made_.corner;
    std::array<std::uint32_t, 4> packed{bitsOf(from.x), bitsOf(from.y), bitsOf(to.x), bitsOf(to.y)};
    packed[0] = (packed[0] & ~3u) | static_cast<std::uint32_t>(piece.kind);
    forSquares(glm::min(from, to), glm::max(from, to), kWayReachM,
               [&](std::size_t square, const glm::dvec2& place) {
                 if (shared::awayFromWay(place, from, to) < kWayReachM + kHalfDiagonalM)
                   pieces_[square].push_back(packed);
               });
  }

  void add(const terrain::HousePart& part) {
    const glm::dvec2 at = glm::dvec2(part.foot.x, part.foot.z) - made_.corner;
    PlacedPart placed;
    placed.x = static_cast<float>(at.x), placed.z = static_cast<float>(at.y);
    placed.footM = static_cast<float>(part.foot.y), placed.skirtM = static_cast<float>(part.skirtM);
    placed.width = static_cast<float>(part.shape.widthM),
    placed.length = static_cast<float>(part.shape.lengthM);
    placed.wall = static_cast<float>(part.shape.wallM), placed.roof = static_cast<float>(part.shape.roofM);
    placed.alongX = static_cast<float>(part.along.x), placed.alongZ = static_cast<float>(part.along.y);
    placed.ridge = static_cast<float>(part.shape.ridge);
    placed.landM = part.standsOnLand ? static_cast<float>(part.landM) : -1e9f;
    placed.bits = part.bits, placed.use = static_cast<std::uint32_t>(part.use);
    made_.parts.push_back(placed);
    if (!part.standsOnLand) return;
    const std::array<std::array<std::uint32_t, 4>, 2> packed{
        {{bitsOf(at.x), bitsOf(at.y), bitsOf(part.foot.y), bitsOf(part.shape.widthM / 2)},
         {bitsOf(part.along.x), bitsOf(part.along.y), bitsOf(part.shape.lengthM / 2),
          bitsOf(part.shape.wallM + 0.55 * part.shape.roofM)}}};
    forSquares(at, at, kShadowReachM + kHalfDiagonalM, [&](std::size_t square, const glm::dvec2& place) {
      const glm::dvec2 past = glm::max(glm::abs(place - at) - kPlaceGridM / 2, 0.0);
      if (glm::length(past) < kShadowReachM) houses_[square].push_back(packed);
    });
  }

  PlaceMapData finish() {
    std::size_t next = kVillageTexels * kMostVillages;
    for (std::size_t square = 0; square < made_.grid.size(); ++square) {
      const auto pieces =
          static_cast<std::uint32_t>(std::min<std::size_t>(pieces_[square].size(), kMostInSquare));
      const auto houses =
          static_cast<std::uint32_t>(std::min<std::size_t>(houses_[square].size(), kMostInSquare));
      if (next + pieces + 2 * houses > made_.data.size()) break;
      if (pieces > 0) made_.grid[square][0] |= pieces << 16 | static_cast<std::uint32_t>(next);
      for (std::uint32_t i = 0; i < pieces; ++i) made_.data[next++] = pieces_[square][i];
      if (houses > 0) made_.grid[square][1] = houses << 16 | static_cast<std::uint32_t>(next);
      for (std::uint32_t i = 0; i < houses; ++i) {
        made_.data[next++] = houses_[square][i][0];
        made_.data[next++] = houses_[square][i][1];
      }
    }
    return std::move(made_);
  }

 private:
  template <class F>
  void forSquares(const glm::dvec2& lo, const glm::dvec2& hi, double reach, const F& f) const {
    const glm::ivec2 first = glm::max(glm::ivec2(glm::floor((lo - reach) / kPlaceGridM)), 0);
    const glm::ivec2 last = glm::min(glm::ivec2(glm::floor((hi + reach) / kPlaceGridM)), kPlaceGridSide - 1);
    for (int z = first.y; z <= last.y; ++z)
      for (int x = first.x; x <= last.x; ++x)
        f(static_cast<std::size_t>(z * kPlaceGridSide + x), (glm::dvec2(x, z) + 0.5) * kPlaceGridM);
  }

  PlaceMapData made_;
  std::vector<std::vector<std::array<std::uint32_t, 4>>> pieces_;
  std::vector<std::vector<std::array<std::array<std::uint32_t, 4>, 2>>> houses_;
  std::vector<double> nearest_;
};

}  // namespace

PlaceMapData placeMapData(const terrain::Places& places, std::int64_t cellX, std::int64_t cellZ) {
  const glm::dvec2 cell(static_cast<double>(cellX), static_cast<double>(cellZ));
  Packer packer((cell - static_cast<double>(kPlaceCells / 2)) * terrain::kPlaceCellM);
  const terrain::PlacesAround around =
      places.around((cell + 0.5) * terrain::kPlaceCellM, 0.5 * kPlaceCells * terrain::kPlaceCellM);
  for (const auto& village : around.villages) packer.add(*village);
  for (const auto& road : around.roads) {
    for (const terrain::WayPiece& piece : road->pieces) packer.add(piece);
    for (const terrain::HousePart& deck : road->decks) packer.add(deck);
  }
  return packer.finish();
}

}  // namespace skydrop::render
