#include "terrain/village_plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "skydrop/core/deterministic_math.h"
#include "skydrop/core/hash.h"

namespace skydrop::terrain {
namespace {

namespace shared = core::shared::f64;
namespace dmath = core::dmath;

constexpr int kTries = 12;
constexpr double kAsideM = 300;  // of the middle from its cell's, along each axis
constexpr double kCoreM = 90;    // around the middle, that must be gentle
constexpr double kMostCoreSlope = 0.17;
constexpr double kLowestM = 6, kHighestM = 480;
constexpr double kStepM = 16;  // of streets
constexpr std::size_t kMostParts = 160;
constexpr double kFromStripM = 60, kBeforeStripM = 420;
constexpr double kJettyReachM = 700;

double lengthOf(const glm::dvec2& v) { return std::sqrt(v.x * v.x + v.y * v.y); }
glm::dvec2 rightOf(const glm::dvec2& v) { return {-v.y, v.x}; }
double slopeOf(const HeightSample& s) { return lengthOf(s.gradient); }
glm::dvec2 turnedBy(const glm::dvec2& v, double angle) {
  const double c = dmath::cos(angle), s = dmath::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

class Planner {
 public:
  Planner(const HeightSource& ground, const PlacesSettings& settings, std::int64_t cellX, std::int64_t cellZ)
      : ground_(ground),
        settings_(settings),
        cell_(static_cast<double>(cellX), static_cast<double>(cellZ)),
        random_{core::hashCombine(core::hashCombine(0x706c61636573ull, static_cast<std::uint64_t>(cellX)),
                                  static_cast<std::uint64_t>(cellZ)),
                0} {}

  std::shared_ptr<const Village> plan() {
    if (random_.nextUnit() >= settings_.density || !findSite()) return nullptr;
    layStreets();
    buildChurch();
    buildAlongStreets();
    if (village_.parts.size() < 5) return nullptr;
    markGardens();
    layFields();
    buildFarms();
    buildJetty();
    return std::make_shared<const Village>(std::move(village_));
  }

 private:
  double random(double low, double high) { return low + (high - low) * random_.nextUnit(); }

  bool isFree(const glm::dvec2& xz) const {
    const auto strip = strip_;
    if (!strip) return true;
    const glm::dvec2 at = strip->local(xz);
    return std::abs(at.x) > strip->halfLength + kBeforeStripM ||
           std::abs(at.y) > strip->halfWidth + kFromStripM;
  }

  bool findSite() {
    const glm::dvec2 middle = (cell_ + 0.5) * kPlaceCellM;
    if (const Strips* strips = ground_.strips()) strip_ = strips->nearest(middle, 3000);
    double best = 1e9;
    for (int i = 0; i < kTries; ++i) {
      const double x = random(-kAsideM, kAsideM), z = random(-kAsideM, kAsideM);
      const glm::dvec2 at = middle + glm::dvec2(x, z);
      double worst = 0;
      glm::dvec2 gradient(0);
      bool fits = isFree(at);
      for (int k = 0; k < 9 && fits; ++k) {
        const double out = k == 0 ? 0 : kCoreM;
        const glm::dvec2 aside = turnedBy({out, 0}, k * dmath::kTwoPi / 8);
        const HeightSample s = ground_.sample(at + aside);
        worst = std::max(worst, slopeOf(s));
        gradient += s.gradient;
        fits = s.height > kLowestM && s.height < kHighestM && worst < kMostCoreSlope;
      }
      if (!fits || worst >= best) continue;
      best = worst;
      village_.middle = at;
      // Along the slope, so that the street is level.
      const double length = lengthOf(gradient);
      village_.along = length > 1e-3 ? rightOf(gradient) / length : glm::dvec2(1, 0);
    }
    village_.bits = static_cast<std::uint32_t>(random_.next() >> 32);
    return best < 1e9;
  }

  bool isWayFit(const glm::dvec2& xz, double mostSlope) const {
    const HeightSample s = ground_.sample(xz);
    return s.height > 2.5 && slopeOf(s) < mostSlope && isFree(xz);
  }

  // A street from a place on, bent a little; the places it goes through.
  std::vector<glm::dvec2> street(glm::dvec2 at, glm::dvec2 along, double lengthM, double bend) {
    std::vector<glm::dvec2> places{at};
    const int steps = static_cast<int>(lengthM / kStepM);
    for (int i = 0; i < steps; ++i) {
      along = turnedBy(along, bend * kStepM);
      at += along * kStepM;
      if (!isWayFit(at, 0.24)) break;
      places.push_back(at);
    }
    return places;
  }
  // Every second place: a street bends little.
  void lay(const std::vector<glm::dvec2>& places, WayKind kind) {
    for (std::size_t i = 0; i + 1 < places.size(); i += 2) {
      const std::size_t next = std::min(i + 2, places.size() - 1);
      village_.ways.push_back({places[i], places[next], kind});
    }
  }

  void layStreets() {
    const double size = random(0.75, 1.25);
    for (int side = 0; side < 2; ++side) {
      const glm::dvec2 along = village_.along * (side == 0 ? 1.0 : -1.0);
      const auto places = street(village_.middle, along, size * random(110, 190), random(-0.0022, 0.0022));
      lay(places, WayKind::street);
      streets_.push_back(places);
      const auto i = static_cast<std::size_t>(side);
      village_.ends[i] = places.back();
      village_.before[i] = places.size() > 1 ? places[places.size() - 2] : places.back() - along;
    }
    const int lanes = static_cast<int>(random(2, 4.99));
    const std::vector<std::vector<glm::dvec2>> mains = streets_;
    for (int lane = 0; lane < lanes; ++lane) {
      const auto& main = mains[static_cast<std::size_t>(lane % 2)];
      const auto at = static_cast<std::size_t>(random(
          lane < 2 ? 1.0 : 0.45 * static_cast<double>(main.size()), static_cast<double>(main.size()) - 0.01));
      if (at == 0 || at >= main.size()) continue;
      const glm::dvec2 way = (main[at] - main[at - 1]) / kStepM;
      const double side = random_.nextUnit() < 0.5 ? 1 : -1;
      const auto places = street(main[at], turnedBy(rightOf(way) * side, random(-0.25, 0.25)),
                                 size * random(70, 140), random(-0.004, 0.004));
      if (places.size() < 3) continue;
      lay(places, WayKind::street);
      streets_.push_back(places);
    }
  }

  double awayFromWays(const glm::dvec2& xz) const {
    double least = 1e9;
    for (const WayPiece& way : village_.ways)
      least = std::min(least, shared::awayFromWay(xz, way.from, way.to));
    return least;
  }

  // A building whose ground bears it; `aside`: how far from ways it has to be besides half its width.
  bool build(const glm::dvec2& xz, const glm::dvec2& along, int use, std::uint32_t bits, double fromWays,
             double fromOthers, bool isWing = false) {
    if (village_.parts.size() >= kMostParts) return false;
    HousePart part;
    part.shape = shared::houseOf(bits, use);
    part.use = use;
    part.bits = bits;
    part.along = along;
    const double wide = part.shape.widthM / 2, deep = part.shape.lengthM / 2;
    if (isWing) part.shape.wallM = std::min(part.shape.wallM, 3.0), part.shape.roofM *= 0.8;
    const HeightSample middle = ground_.sample(xz);
    if (middle.height < kLowestM - 1.5 || slopeOf(middle) > kMostHouseSlope || !isFree(xz)) return false;
    double low = middle.height, high = middle.height;
    for (int k = 0; k < 4; ++k) {
      const glm::dvec2 corner =
          xz + along * (k % 2 == 0 ? deep : -deep) + rightOf(along) * (k < 2 ? wide : -wide);
      const double height = ground_.height(corner);
      low = std::min(low, height), high = std::max(high, height);
    }
    if (high - low > 2.2 || low < kLowestM - 2) return false;
    const double radius = std::max(wide, deep);
    if (awayFromWays(xz) < fromWays + (fromWays > 0 ? std::min(wide, deep) : 0)) return false;
    for (const HousePart& other : village_.parts) {
      if (fromOthers <= 0) break;
      const double otherRadius = std::max(other.shape.widthM, other.shape.lengthM) / 2;
      const glm::dvec2 d(other.foot.x - xz.x, other.foot.z - xz.y);
      if (lengthOf(d) < 0.85 * (radius + otherRadius) + fromOthers) return false;
    }
    // The floor lies a little over the highest corner, but never so that walls would stand on stilts.
    const double floor = std::min(high + 0.15, middle.height + 1.1);
    part.foot = {xz.x, floor, xz.y};
    part.landM = middle.height;
    part.skirtM = floor - low + 1.2;
    village_.parts.push_back(part);
    return true;
  }

  std::uint32_t bits() { return static_cast<std::uint32_t>(random_.next() >> 32); }

  void buildChurch() {
    if (streets_[0].size() < 4 || random_.nextUnit() > 0.75) return;
    const glm::dvec2 at = streets_[0][1];
    for (const double side : {1.0, -1.0}) {
      const glm::dvec2 along = turnedBy(village_.along, random(-0.1, 0.1));
      const glm::dvec2 place = at + rightOf(village_.along) * (side * 26);
      const std::uint32_t of = bits();
      if (!build(place, along, shared::kNave, of, 8, 3)) continue;
      build(place - along * 11.2, along, shared::kTower, of, 4, 0);
      return;
    }
  }

  void buildAlongStreets() {
    for (const auto& places : streets_) {
      for (const double side : {1.0, -1.0}) {
        double next = random(6, 16);
        for (std::size_t i = 1; i < places.size(); ++i) {
          const glm::dvec2 way = (places[i] - places[i - 1]) / kStepM;
          const double begin = static_cast<double>(i - 1) * kStepM;
          while (next < begin + kStepM) {
            const double at = next - begin;
            next += random(15, 25);
            if (random_.nextUnit() < 0.10) continue;
            const bool isGableOn = random_.nextUnit() < 0.35;  // its gable to the street
            const int use = random_.nextUnit() < 0.13 ? shared::kBarn : shared::kDwelling;
            const std::uint32_t of = bits();
            const shared::House shape = shared::houseOf(of, use);
            const double depth = (isGableOn ? shape.lengthM : shape.widthM) / 2;
            const double back = 2.4 + random(3.2, 7.5) + depth;
            const glm::dvec2 place = places[i - 1] + way * at + rightOf(way) * (side * back);
            const glm::dvec2 along = turnedBy(isGableOn ? rightOf(way) : way, random(-0.07, 0.07));
            if (!build(place, along, use, of, 4.5, 1.5)) continue;
            if (use == shared::kDwelling && random_.nextUnit() < 0.30) {
              // A wing or shed at its back, across it.
              const glm::dvec2 wing = place + rightOf(way) * (side * (depth + 2.0)) + way * random(-3, 3);
              build(wing, turnedBy(along, dmath::kHalfPi), use, of ^ 0x00070003u, 4.5, 0, true);
            }
          }
        }
      }
    }
  }

  glm::dvec2 blocksOf(const glm::dvec2& xz) const {
    return shared::blocksOf(village_.local(xz), village_.bits);
  }
  void mark(int column, int row, int kind) {
    if (column < 0 || row < 0 || column >= shared::kFieldBlocks || row >= shared::kFieldBlocks) return;
    std::uint32_t& line = village_.blocks[static_cast<std::size_t>(row)];
    line = (line & ~(3u << (2 * column))) | static_cast<std::uint32_t>(kind) << (2 * column);
  }

  // Blocks with houses, where they reach to 10 m beside them.
  void markGardens() {
    for (const HousePart& part : village_.parts) {
      for (int k = 0; k < 9; ++k) {
        const glm::dvec2 aside = glm::dvec2(k % 3 - 1, k / 3 - 1) * 12.0;
        const glm::dvec2 at = blocksOf(glm::dvec2(part.foot.x, part.foot.z) + aside);
        mark(static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)), shared::kGardenBlock);
      }
    }
  }

  glm::dvec2 worldOf(const glm::dvec2& blocks) const {
    return village_.world(shared::placeInBlocks(blocks, village_.bits));
  }

  bool isGentleAt(const glm::dvec2& blocks) const {
    const glm::dvec2 xz = worldOf(blocks);
    const HeightSample s = ground_.sample(xz);
    return s.height > 5 && s.height < 560 && slopeOf(s) < kMostFieldSlope && isFree(xz);
  }
  // A block by its corners, each looked at once for all four blocks that have it, and its middle.
  bool isGentle(int column, int row) {
    for (int k = 0; k < 4; ++k) {
      const int x = column + k % 2, z = row + k / 2;
      std::int8_t& known = corners_[static_cast<std::size_t>(z * (shared::kFieldBlocks + 1) + x)];
      if (known == 0) known = isGentleAt(glm::dvec2(x, z)) ? 1 : -1;
      if (known < 0) return false;
    }
    return isGentleAt(glm::dvec2(column + 0.5, row + 0.5));
  }

  void layFields() {
    for (int row = 0; row < shared::kFieldBlocks; ++row) {
      for (int column = 0; column < shared::kFieldBlocks; ++column) {
        const double chance = random_.nextUnit();
        if (village_.blockAt(glm::dvec2(column + 0.5, row + 0.5)) != shared::kNoBlock) continue;
        const glm::dvec2 d(column - 7.5, row - 7.5);
        // Thinner towards the edge.
        const double away = lengthOf(d) / 8.0;
        if (away > 1 || chance > settings_.fields * (1.25 - 0.75 * away * away)) continue;
        if (isGentle(column, row)) mark(column, row, shared::kCropBlock);
      }
    }
  }

  // A straight track as far as the land bears it: false where it does not.
  bool track(const glm::dvec2& from, const glm::dvec2& to) {
    const glm::dvec2 way = to - from;
    const double length = lengthOf(way);
    const int steps = std::max(static_cast<int>(length / 20), 1);
    for (int i = 1; i < steps; ++i)
      if (!isWayFit(from + way * (static_cast<double>(i) / steps), 0.26)) return false;
    const glm::dvec2 aside = rightOf(way) * random(-0.09, 0.09);
    glm::dvec2 last = from;
    const int pieces = std::max(static_cast<int>(length / 24), 1);
    for (int i = 1; i <= pieces; ++i) {
      const double t = static_cast<double>(i) / pieces;
      const glm::dvec2 at = from + way * t + aside * (4 * t * (1 - t));
      village_.ways.push_back({last, at, WayKind::track});
      last = at;
    }
    return true;
  }

  // Where the nearest street ends.
  glm::dvec2 nearestEnd(const glm::dvec2& xz) const {
    glm::dvec2 best = village_.middle;
    double least = 1e9;
    for (const auto& places : streets_) {
      const double away = lengthOf(places.back() - xz);
      if (away < least) least = away, best = places.back();
    }
    return best;
  }

  void buildFarms() {
    const int farms = static_cast<int>(random(1, 5));
    for (int i = 0; i < farms; ++i) {
      const glm::dvec2 way = turnedBy({1, 0}, random(0, dmath::kTwoPi));
      const glm::dvec2 at = village_.middle + way * random(260, 560);
      const glm::dvec2 blocks = blocksOf(at);
      const std::uint32_t house = bits(), barn = bits();
      const glm::dvec2 along = turnedBy(village_.along, random(-0.3, 0.3));
      if (village_.blockAt(blocks) != shared::kCropBlock) continue;
      const glm::dvec2 gate = at - way * 16.0;
      if (!isWayFit(gate, 0.24) || !build(at, along, shared::kDwelling, house, 3, 8)) continue;
      build(at + rightOf(along) * 21.0, turnedBy(along, dmath::kHalfPi), shared::kBarn, barn, 3, 1);
      mark(static_cast<int>(std::floor(blocks.x)), static_cast<int>(std::floor(blocks.y)),
           shared::kGardenBlock);
      track(nearestEnd(at), gate);
    }
  }

  // Planks from the beach out to where a boat floats, and the track there.
  void buildJetty() {
    double nearest = kJettyReachM;
    glm::dvec2 outwards(0);
    for (int k = 0; k < 12; ++k) {
      const glm::dvec2 way = turnedBy({1, 0}, k * dmath::kTwoPi / 12);
      for (double out = 60; out < nearest; out += 30) {
        if (ground_.height(village_.middle + way * out) > 0.3) continue;
        nearest = out, outwards = way;
      }
    }
    if (nearest >= kJettyReachM) return;
    const glm::dvec2 shore = village_.middle + outwards * (nearest - 30);
    const HeightSample beach = ground_.sample(shore);
    if (slopeOf(beach) > 0.35 || beach.height > 7 || !isFree(shore)) return;
    const double length = random(34, 58);
    const glm::dvec2 end = shore + outwards * (30 + length);
    if (ground_.height(end) > -0.5) return;
    track(nearestEnd(shore), shore - outwards * 6.0);  // or on foot
    addDeck(shore - outwards * 6.0, end, std::max(1.3, 1.0), 2.4);
    addDeck(end - rightOf(outwards) * 7.0, end + rightOf(outwards) * 7.0, 1.3, 2.6);
  }

  void addDeck(const glm::dvec2& from, const glm::dvec2& to, double height, double wide) {
    const glm::dvec2 way = to - from;
    const double length = lengthOf(way);
    const glm::dvec2 along = way / length;
    const auto part = [&](const glm::dvec2& xz, double across, double lengthM, double wall, double skirt,
                          double lift) {
      HousePart made;
      made.foot = {xz.x, height + lift, xz.y};
      made.along = along;
      made.shape = {across, lengthM, wall, 0, 1};
      made.skirtM = skirt;
      made.use = shared::kDeck;
      made.bits = bits();
      made.standsOnLand = false;
      village_.parts.push_back(made);
    };
    part((from + to) / 2.0, wide, length, 0.22, 0.05, 0);
    const int posts = std::max(static_cast<int>(length / 7), 1);
    for (int i = 0; i <= posts; ++i) {
      const glm::dvec2 at = from + way * ((i + 0.02) / (posts + 0.04));
      for (const double side : {1.0, -1.0})
        part(at + rightOf(along) * (side * wide / 2), 0.3, 0.3, 1.0, 7, 0);
    }
  }

  const HeightSource& ground_;
  const PlacesSettings& settings_;
  glm::dvec2 cell_;
  core::RandomStream random_;
  std::optional<Strip> strip_;
  Village village_;
  std::array<std::int8_t, (shared::kFieldBlocks + 1) * (shared::kFieldBlocks + 1)>
      corners_{};  // 1 gentle, -1 not
  std::vector<std::vector<glm::dvec2>> streets_;
};

}  // namespace

std::shared_ptr<const Village> planVillage(const HeightSource& ground, const PlacesSettings& settings,
                                           std::int64_t cellX, std::int64_t cellZ) {
  return Planner(ground, settings, cellX, cellZ).plan();
}

}  // namespace skydrop::terrain
