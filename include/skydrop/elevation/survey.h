// What one look at all cells of a raster finds: voids and what fills them, edges, and bounds.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "skydrop/elevation/raster.h"

namespace skydrop::elevation {

struct Bounds {
  float lowest, highest;  // m; lowest > highest: of nothing
};

// A value; any thread may ask.
class Survey {
 public:
  // Reads the raster once, in bands. Throws core::DataError where it cannot be read, where not one cell has a
  // height, and where there are more than kMostRuns runs of voids.
  static constexpr std::size_t kMostRuns = 1 << 20;
  explicit Survey(const Raster& raster);

  std::size_t voids() const { return voids_; }
  Bounds all() const { return {lowest_, highest_}; }  // of the heights that there are
  double mean() const { return mean_; }

  // What a void is taken for: the mean of the nearest heights to west, east, north and south in the raster,
  // weighted by 1/d^2; where there are none, the mean of all. A cell that is no void must not be asked for.
  float filled(int column, int row) const;

  // The outermost cells, voids filled: north and south by column, west and east by row.
  const std::vector<float>& north() const { return edges_[0]; }
  const std::vector<float>& south() const { return edges_[1]; }
  const std::vector<float>& west() const { return edges_[2]; }
  const std::vector<float>& east() const { return edges_[3]; }

  // Of the cells of a rectangle (inclusive; what lies outside the raster counts as its nearest cell), voids
  // filled. Conservative: of squares of at least kSquare cells that cover it.
  static constexpr int kSquare = 32;
  Bounds within(int column, int row, int lastColumn, int lastRow) const;

  // How far a bicubic surface through heights leaves them: by this share of their range, to each side.
  // Catmull-Rom weights of two axes: those below zero sum to 2 * 9/8 * 1/8.
  static constexpr float kOvershoot = 0.28125F;
  // Of the bicubic surface through all heights.
  Bounds ofSurface() const;

 private:
  // Voids in a row (or column) from `first` up to before `past`, and the heights on both sides; NaN at an
  // edge.
  struct Run {
    std::int32_t line, first, past;
    float before, after;
  };
  struct Level {
    int columns = 0, rows = 0;
    std::vector<Bounds> squares;
  };

  void scan(const Raster& raster);
  void makeLevels();
  void coverVoids();
  static const Run* runAt(const std::vector<Run>& runs, int line, int place);

  int width_, height_;
  std::size_t voids_ = 0;
  float lowest_ = 0, highest_ = 0;
  double mean_ = 0;
  std::vector<Run> rowRuns_, columnRuns_;  // sorted by line, then place
  std::array<std::vector<float>, 4> edges_;
  std::vector<Level> levels_;  // of squares, each of twice the side
};

}  // namespace skydrop::elevation
