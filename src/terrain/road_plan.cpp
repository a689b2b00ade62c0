#include "terrain/road_plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "skydrop/core/hash.h"

namespace skydrop::terrain {
namespace {

namespace shared = core::shared::f64;

constexpr int kLevels = 4;       // of halving: sixteenths of the way
constexpr int kCandidates = 3;   // to each side
constexpr int kCurvePieces = 5;  // between two of its points
constexpr double kShoreM = 1.5;
constexpr double kDeckM = 1.7, kDeckWideM = 6.4;

double lengthOf(const glm::dvec2& v) { return std::sqrt(v.x * v.x + v.y * v.y); }
glm::dvec2 rightOf(const glm::dvec2& v) { return {-v.y, v.x}; }

class Planner {
 public:
  explicit Planner(const HeightSource& ground) : ground_(ground) {}

  // What a straight piece costs: its length, more where it climbs, lies across a slope, or is wet.
  double cost(const glm::dvec2& from, const glm::dvec2& to) const {
    constexpr int kLooks = 3;
    const glm::dvec2 way = to - from;
    const double length = std::max(lengthOf(way), 1e-6);
    const glm::dvec2 along = way / length;
    double sum = 0;
    for (int i = 0; i < kLooks; ++i) {
      const HeightSample s = ground_.sample(from + way * ((i + 0.5) / kLooks));
      const double grade = std::abs(s.gradient.x * along.x + s.gradient.y * along.y);
      const double across = std::abs(s.gradient.x * along.y - s.gradient.y * along.x);
      sum += 1 + 180 * grade * grade + 14 * across * across + (grade > 0.12 ? 60 * (grade - 0.12) : 0) +
             (across > 0.32 ? 30 * (across - 0.32) : 0) + (s.height < kShoreM ? 14 : 0);
    }
    return sum / kLooks * length;
  }

  // Points of the way from first to last, halved again and again, each half's middle moved aside to where
  // both halves cost least.
  void bend(std::vector<glm::dvec2>& points, std::size_t first, std::size_t last, int level) const {
    if (level == 0) return;
    const glm::dvec2 way = points[last] - points[first];
    const std::size_t middle = (first + last) / 2;
    double best = 1e300;
    for (int k = -kCandidates; k <= kCandidates; ++k) {
      const double aside = 0.30 * k / kCandidates;
      const glm::dvec2 at = (points[first] + points[last]) / 2.0 + rightOf(way) * aside;
      const double all = cost(points[first], at) + cost(at, points[last]);
      if (all < best) best = all, points[middle] = at;
    }
    bend(points, first, middle, level - 1);
    bend(points, middle, last, level - 1);
  }

  static glm::dvec2 onCurve(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c,
                            const glm::dvec2& d, double t) {
    return 0.5 * (2.0 * b + (c - a) * t + (2.0 * a - 5.0 * b + 4.0 * c - d) * (t * t) +
                  (3.0 * b - a - 3.0 * c + d) * (t * t * t));
  }

  HeightSample at(const glm::dvec2& xz) const { return ground_.sample(xz); }
  static bool isWet(const HeightSample& a, const HeightSample& b) {
    return a.height < kShoreM || b.height < kShoreM;
  }
  static bool isTooSteep(const WayPiece& piece, const HeightSample& a, const HeightSample& b) {
    const glm::dvec2 way = piece.to - piece.from;
    const double length = std::max(lengthOf(way), 1e-6);
    const double across = std::abs(b.gradient.x * way.y - b.gradient.y * way.x) / length;
    return std::abs(b.height - a.height) > kMostGrade * length || across > kMostCrossfall;
  }

  const HeightSource& ground_;
};

void addDeck(Road& road, const WayPiece& piece, std::uint64_t bits) {
  const glm::dvec2 way = piece.to - piece.from;
  const double length = lengthOf(way);
  const glm::dvec2 along = way / length, middle = (piece.from + piece.to) / 2.0;
  const auto part = [&](const glm::dvec2& xz, double height, double wide, double lengthM, double wall,
                        double skirt) {
    HousePart made;
    made.foot = {xz.x, height, xz.y};
    made.along = along;
    made.shape = {wide, lengthM, wall, 0, 1};
    made.skirtM = skirt;
    made.use = shared::kDeck;
    made.bits = static_cast<std::uint32_t>(bits >> 32);
    made.standsOnLand = false;
    road.decks.push_back(made);
  };
  part(middle, kDeckM, kDeckWideM, length + 0.4, 0.35, 0.5);
  for (const double side : {1.0, -1.0})
    part(middle + rightOf(along) * (side * kDeckWideM / 2), kDeckM, 0.2, length + 0.4, 1.2, 0);
  part(piece.from, kDeckM, kDeckWideM - 1.2, 1.0, 0.1, 9);
}

}  // namespace

Road planRoad(const HeightSource& ground, const Village& from, const Village& to, std::uint64_t bits) {
  const Planner planner(ground);
  const auto nearer = [](const Village& of, const glm::dvec2& other) -> std::size_t {
    return lengthOf(of.ends[0] - other) <= lengthOf(of.ends[1] - other) ? 0 : 1;
  };
  const std::size_t a = nearer(from, to.middle), b = nearer(to, from.middle);
  constexpr std::size_t kLast = 1u << kLevels;
  std::vector<glm::dvec2> points(kLast + 1);
  points.front() = from.ends[a], points.back() = to.ends[b];
  planner.bend(points, 0, kLast, kLevels);

  Road road;
  glm::dvec2 last = points.front();
  HeightSample lastLand = planner.at(last);
  double wetM = 0;
  std::vector<WayPiece> wet;
  for (std::size_t i = 0; i < kLast; ++i) {
    const glm::dvec2 before = i == 0 ? from.before[a] : points[i - 1];
    const glm::dvec2 after = i + 1 == kLast ? to.before[b] : points[i + 2];
    for (int k = 1; k <= kCurvePieces; ++k) {
      const glm::dvec2 at =
          Planner::onCurve(before, points[i], points[i + 1], after, static_cast<double>(k) / kCurvePieces);
      const WayPiece piece{last, at, WayKind::road};
      const HeightSample land = planner.at(at);
      const bool isWet = Planner::isWet(lastLand, land);
      if (!isWet && Planner::isTooSteep(piece, lastLand, land)) return {};
      if (isWet) {
        wetM += lengthOf(at - last);
        if (wetM > kLongestBridgeM) return {};
        wet.push_back(piece);
      } else {
        wetM = 0;
      }
      road.pieces.push_back(piece);
      last = at, lastLand = land;
    }
  }
  for (const WayPiece& piece : wet) addDeck(road, piece, bits);
  return road;
}

}  // namespace skydrop::terrain
