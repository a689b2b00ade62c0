#include "skydrop/terrain/places.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "skydrop/core/hash.h"
#include "terrain/road_plan.h"
#include "terrain/village_plan.h"

namespace skydrop::terrain {
namespace {

namespace shared = core::shared::f64;

constexpr double kFarthestM = 1e12;
constexpr double kWidestQueryM = 20000;
constexpr double kVillageReachM = 960;  // of all that belongs to one, from its middle
constexpr double kRoadReachM = 2600;    // from the middle of the cell it begins in, and back
constexpr std::size_t kMostRemembered = 4096;
constexpr std::uint64_t kRoadSeed = 0x726f616473ull;
constexpr double kDiagonalShare = 0.3;

bool isInReach(const glm::dvec2& xz) { return std::abs(xz.x) < kFarthestM && std::abs(xz.y) < kFarthestM; }
std::int64_t cellOf(double metres) { return static_cast<std::int64_t>(std::floor(metres / kPlaceCellM)); }
double lengthOf(const glm::dvec2& v) { return std::sqrt(v.x * v.x + v.y * v.y); }

// Whether a point is nearer than reachM to a part: its walls, and the roof as high as it is there.
bool touches(const HousePart& part, const glm::dvec3& point, double reachM) {
  const glm::dvec3 d = point - part.foot;
  const double along = std::abs(d.x * part.along.x + d.z * part.along.y);
  const double across = std::abs(d.z * part.along.x - d.x * part.along.y);
  const double wide = part.shape.widthM / 2, deep = part.shape.lengthM / 2;
  if (along > deep + reachM || across > wide + reachM || d.y < -part.skirtM - reachM) return false;
  const double fromRidge = std::min(across / wide, 1.0);
  const double fromEnd =
      part.shape.ridge < 1 ? std::clamp((deep - along) / (deep * (1 - part.shape.ridge)), 0.0, 1.0) : 1.0;
  return d.y < part.shape.wallM + part.shape.roofM * std::min(1 - fromRidge, fromEnd) + reachM;
}

bool isOnWay(std::span<const WayPiece> ways, const glm::dvec2& xz) {
  return std::ranges::any_of(ways, [&](const WayPiece& way) {
    return shared::awayFromWay(xz, way.from, way.to) <
           shared::wayHalfM(static_cast<int>(way.kind)) + shared::kTreesFromWayM;
  });
}

}  // namespace

void describe(core::SettingsVisitor& v, PlacesSettings& s) {
  v.number("density", s.density,
           {.unit = "1",
            .min = 0,
            .max = 1,
            .help = "Share of the land's squares of 1.9 km that have a village where one fits.",
            .aliases = "villages, houses, towns, roads"});
  v.number("fields", s.fields,
           {.unit = "1",
            .min = 0,
            .max = 1,
            .help = "Share of the gentle land around villages that is tilled.",
            .aliases = "farms, crops, hedges, plots"});
  v.flag(
      "obstacles", s.obstacles,
      {.help = "A house that the aircraft touches ends the flight.", .aliases = "collision, houses, crash"});
}

int Village::blockAt(const glm::dvec2& inBlocks) const {
  const double side = shared::kFieldBlocks;
  if (!(inBlocks.x >= 0 && inBlocks.y >= 0 && inBlocks.x < side && inBlocks.y < side))
    return shared::kNoBlock;
  const auto column = static_cast<unsigned>(inBlocks.x), row = static_cast<unsigned>(inBlocks.y);
  return static_cast<int>(blocks[row] >> (2 * column) & 3u);
}

bool PlacesAround::isSettled(const glm::dvec2& xz) const {
  for (const auto& village : villages) {
    const glm::dvec2 at = village->local(xz);
    if (std::abs(at.x) > kVillageReachM || std::abs(at.y) > kVillageReachM) continue;
    if (village->blockAt(shared::blocksOf(at, village->bits)) != shared::kNoBlock ||
        isOnWay(village->ways, xz))
      return true;
  }
  return std::ranges::any_of(roads, [&](const auto& road) { return isOnWay(road->pieces, xz); });
}

std::size_t Places::KeyHash::operator()(const Key& key) const {
  return core::hashCombine(
      core::hashCombine(core::mix64(static_cast<std::uint64_t>(key.x)), static_cast<std::uint64_t>(key.z)),
      static_cast<std::uint64_t>(key.direction));
}

Places::Places(std::shared_ptr<const HeightSource> ground, const PlacesSettings& settings)
    : ground_(std::move(ground)), settings_(settings) {}

std::shared_ptr<const Village> Places::village(std::int64_t cellX, std::int64_t cellZ) const {
  const Key key{cellX, cellZ, 0};
  {
    const std::shared_lock lock(mutex_);
    if (const auto found = villages_.find(key); found != villages_.end()) return found->second;
  }
  const glm::dvec2 middle =
      (glm::dvec2(static_cast<double>(cellX), static_cast<double>(cellZ)) + 0.5) * kPlaceCellM;
  std::shared_ptr<const Village> made =
      settings_.density > 0 && isInReach(middle) ? planVillage(*ground_, settings_, cellX, cellZ) : nullptr;
  const std::unique_lock lock(mutex_);
  if (villages_.size() >= kMostRemembered) villages_.clear();
  return villages_.emplace(key, std::move(made)).first->second;
}

std::shared_ptr<const Road> Places::road(std::int64_t cellX, std::int64_t cellZ, int direction) const {
  const Key key{cellX, cellZ, direction};
  {
    const std::shared_lock lock(mutex_);
    if (const auto found = roads_.find(key); found != roads_.end()) return found->second;
  }
  static const auto kNone = std::make_shared<const Road>();
  core::RandomStream random{
      core::hashCombine(core::hashCombine(core::hashCombine(kRoadSeed, static_cast<std::uint64_t>(cellX)),
                                          static_cast<std::uint64_t>(cellZ)),
                        static_cast<std::uint64_t>(direction)),
      0};
  std::shared_ptr<const Road> made = kNone;
  const bool isWanted = direction < 2 || random.nextUnit() < kDiagonalShare;
  const auto from = isWanted ? village(cellX, cellZ) : nullptr;
  const auto to = from ? village(cellX + (direction == 1   ? 0
                                          : direction == 3 ? -1
                                                           : 1),
                                 cellZ + (direction == 0 ? 0 : 1))
                       : nullptr;
  if (to) made = std::make_shared<const Road>(planRoad(*ground_, *from, *to, random.next()));
  const std::unique_lock lock(mutex_);
  if (roads_.size() >= kMostRemembered) roads_.clear();
  return roads_.emplace(key, std::move(made)).first->second;
}

PlacesAround Places::around(const glm::dvec2& xz, double halfSideM) const {
  PlacesAround result;
  if (!isInReach(xz) || !(halfSideM >= 0) || settings_.density <= 0) return result;
  const double half = std::min(halfSideM, kWidestQueryM);
  const auto isNear = [&](const glm::dvec2& lo, const glm::dvec2& hi, double reach) {
    return lo.x - reach < xz.x + half && hi.x + reach > xz.x - half && lo.y - reach < xz.y + half &&
           hi.y + reach > xz.y - half;
  };
  const double wide = half + kRoadReachM;
  for (std::int64_t z = cellOf(xz.y - wide); z <= cellOf(xz.y + wide); ++z) {
    for (std::int64_t x = cellOf(xz.x - wide); x <= cellOf(xz.x + wide); ++x) {
      const auto of = village(x, z);
      if (!of) continue;
      if (isNear(of->middle, of->middle, kVillageReachM)) result.villages.push_back(of);
      for (int direction = 0; direction < 4; ++direction) {
        const auto way = road(x, z, direction);
        if (way->pieces.empty()) continue;
        glm::dvec2 lo = way->pieces.front().from, hi = lo;
        for (const WayPiece& piece : way->pieces) lo = glm::min(lo, piece.to), hi = glm::max(hi, piece.to);
        if (isNear(lo, hi, shared::kWidestWayM + shared::kTreesFromWayM)) result.roads.push_back(way);
      }
    }
  }
  return result;
}

std::shared_ptr<const Village> Places::nearest(const glm::dvec2& xz, int rings) const {
  std::shared_ptr<const Village> best;
  if (!isInReach(xz)) return best;
  double least = 1e300;
  for (std::int64_t dz = -rings; dz <= rings; ++dz) {
    for (std::int64_t dx = -rings; dx <= rings; ++dx) {
      const auto of = village(cellOf(xz.x) + dx, cellOf(xz.y) + dz);
      if (!of || lengthOf(of->middle - xz) >= least) continue;
      least = lengthOf(of->middle - xz), best = of;
    }
  }
  return best;
}

std::optional<HousePart> Places::touching(std::span<const glm::dvec3> points, double reachM) const {
  if (points.empty() || settings_.density <= 0) return {};
  const glm::dvec2 xz(points[0].x, points[0].z);
  if (!isInReach(xz)) return {};
  double lowest = points[0].y;
  for (const glm::dvec3& point : points) lowest = std::min(lowest, point.y);
  const double widest = 20 + reachM + 30;  // the ground of a house near by may be higher
  if (lowest - std::max(ground_->height(xz), 0.0) > kTallestHouseM + reachM + kMostHouseSlope * widest)
    return {};
  const auto among = [&](std::span<const HousePart> parts) -> const HousePart* {
    for (const HousePart& part : parts) {
      for (const glm::dvec3& point : points)
        if (touches(part, point, reachM)) return &part;
    }
    return nullptr;
  };
  const PlacesAround near = around(xz, widest);
  for (const auto& village : near.villages)
    if (const HousePart* part = among(village->parts)) return *part;
  for (const auto& road : near.roads)
    if (const HousePart* part = among(road->decks)) return *part;
  return {};
}

}  // namespace skydrop::terrain
