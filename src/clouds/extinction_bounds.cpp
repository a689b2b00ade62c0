#include "skydrop/clouds/extinction_bounds.h"

#include <algorithm>
#include <cmath>

#include "skydrop/core/error.h"

namespace skydrop::clouds {
namespace {

constexpr std::int64_t kMostCells = std::int64_t{1} << 25;
constexpr int kSamples = 4;      // of a cell along each axis, on its faces too
constexpr double kPushM = 1e-6;  // past the border of a cell, so that a ray gets on
constexpr float kUnknown = -1;

std::int64_t wrapped(std::int64_t i, std::int64_t n) { return ((i % n) + n) % n; }

// How far a coordinate in cells goes to the border ahead.
double toBorder(double at, double direction, double cellM) {
  if (direction == 0) return 1e30;
  const double border = direction > 0 ? std::floor(at) + 1 : std::ceil(at) - 1;
  return (border - at) * cellM / direction;
}

}  // namespace

ExtinctionBounds::ExtinctionBounds(Near near, double baseM, double topM, double periodM, double cellM,
                                   double rowM)
    : near_(std::move(near)), baseM_(baseM) {
  if (!(topM > baseM && periodM > 0 && cellM > 0 && rowM > 0))
    throw core::RangeError("a grid of extinctions has to have lengths above 0");
  const double side = std::max(1.0, std::round(periodM / cellM)),
               rows = std::max(1.0, std::round((topM - baseM) / rowM));
  if (!(side * side * rows <= static_cast<double>(kMostCells)))
    throw core::RangeError("a grid of extinctions may have 2^25 cells at most");
  side_ = static_cast<std::int64_t>(side);
  rows_ = static_cast<std::int64_t>(rows);
  cell_ = {periodM / side, (topM - baseM) / rows, periodM / side};
  const auto count = static_cast<std::size_t>(side_ * side_ * rows_);
  bounds_ = std::make_unique<std::atomic<float>[]>(count);
  for (std::size_t i = 0; i < count; ++i) bounds_[i].store(kUnknown, std::memory_order_relaxed);
}

double ExtinctionBounds::boundOf(std::int64_t x, std::int64_t row, std::int64_t z) const {
  const std::int64_t column = wrapped(x, side_), line = wrapped(z, side_);
  std::atomic<float>& kept = bounds_[static_cast<std::size_t>((line * rows_ + row) * side_ + column)];
  const float known = kept.load(std::memory_order_relaxed);
  if (known >= 0) return static_cast<double>(known);
  // Two threads may work the same out: they find the same.
  const glm::dvec3 corner =
      glm::dvec3(static_cast<double>(column), static_cast<double>(row), static_cast<double>(line)) * cell_ +
      glm::dvec3(0, baseM_, 0);
  double most = 0;
  for (int k = 0; k < kSamples * kSamples * kSamples; ++k) {
    const glm::dvec3 at = glm::dvec3(k % kSamples, k / kSamples % kSamples, k / (kSamples * kSamples)) /
                          double{kSamples - 1} * cell_;
    most = std::max(most, near_(corner + at));
  }
  const auto bound = static_cast<float>(most);
  kept.store(bound, std::memory_order_relaxed);
  return static_cast<double>(bound);
}

ExtinctionBounds::Piece ExtinctionBounds::pieceAt(const glm::dvec3& place,
                                                  const glm::dvec3& direction) const {
  const glm::dvec3 at = (place - glm::dvec3(0, baseM_, 0)) / cell_;
  const auto row = std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor(at.y)), 0, rows_ - 1);
  const double end = std::min({toBorder(at.x, direction.x, cell_.x), toBorder(at.y, direction.y, cell_.y),
                               toBorder(at.z, direction.z, cell_.z)});
  return {
      boundOf(static_cast<std::int64_t>(std::floor(at.x)), row, static_cast<std::int64_t>(std::floor(at.z))),
      std::max(end, 0.0) + kPushM};
}

}  // namespace skydrop::clouds
