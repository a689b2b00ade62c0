// About how dense a medium gets in each cell of a grid, worked out where it is first asked for: what free
// paths are drawn from. A path tracer stays exact where a bound is exceeded, and is only noisier.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>

namespace skydrop::clouds {

class ExtinctionBounds {
 public:
  // Extinction that is hardly exceeded near a place, 1/m; it is asked a third of a cell apart. 0 in a whole
  // cell and its rim is taken for empty.
  using Near = std::function<double(const glm::dvec3&)>;

  // Cells are about so many metres wide and high; the grid repeats with periodM and has rows from base to
  // top. Throws core::RangeError where it would have more than 2^25 cells or lengths are not positive.
  ExtinctionBounds(Near near, double baseM, double topM, double periodM, double cellM, double rowM);

  // A piece of a ray in one cell.
  struct Piece {
    double bound;  // 1/m
    double endM;   // where it leaves the cell, as a length along the direction from the place
  };
  // Of a place between base and top. Any thread; what comes back depends on the place alone.
  Piece pieceAt(const glm::dvec3& place, const glm::dvec3& direction) const;

 private:
  double boundOf(std::int64_t x, std::int64_t row, std::int64_t z) const;

  Near near_;
  double baseM_;
  glm::dvec3 cell_;  // m
  std::int64_t side_, rows_;
  std::unique_ptr<std::atomic<float>[]> bounds_;  // below 0: not asked for yet
};

}  // namespace skydrop::clouds
