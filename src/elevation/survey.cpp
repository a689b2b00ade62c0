#include "skydrop/elevation/survey.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "skydrop/core/error.h"

namespace skydrop::elevation {
namespace {

using core::DataError;

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr Bounds kNothing{std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest()};
constexpr std::size_t kBandBytes = std::size_t{16} << 20;

bool isVoid(float height) { return height != height; }

void fold(Bounds& bounds, float height) {
  if (isVoid(height)) return;
  bounds.lowest = std::min(bounds.lowest, height);
  bounds.highest = std::max(bounds.highest, height);
}
void fold(Bounds& bounds, const Bounds& other) {
  bounds.lowest = std::min(bounds.lowest, other.lowest);
  bounds.highest = std::max(bounds.highest, other.highest);
}

}  // namespace

Survey::Survey(const Raster& raster) : width_(raster.width()), height_(raster.height()) {
  edges_[0].resize(static_cast<std::size_t>(width_));
  edges_[1].resize(static_cast<std::size_t>(width_));
  edges_[2].resize(static_cast<std::size_t>(height_));
  edges_[3].resize(static_cast<std::size_t>(height_));
  levels_.push_back({(width_ + kSquare - 1) / kSquare, (height_ + kSquare - 1) / kSquare, {}});
  levels_[0].squares.assign(static_cast<std::size_t>(levels_[0].columns) * levels_[0].rows, kNothing);
  scan(raster);
  const auto byLine = [](const Run& a, const Run& b) {
    return a.line != b.line ? a.line < b.line : a.first < b.first;
  };
  std::sort(columnRuns_.begin(), columnRuns_.end(), byLine);  // those of rows come in order
  for (int column = 0; column < width_; ++column) {
    for (const auto& [edge, row] : {std::pair(0, 0), std::pair(1, height_ - 1)}) {
      float& height = edges_[static_cast<std::size_t>(edge)][static_cast<std::size_t>(column)];
      if (isVoid(height)) height = filled(column, row);
    }
  }
  for (int row = 0; row < height_; ++row) {
    for (const auto& [edge, column] : {std::pair(2, 0), std::pair(3, width_ - 1)}) {
      float& height = edges_[static_cast<std::size_t>(edge)][static_cast<std::size_t>(row)];
      if (isVoid(height)) height = filled(column, row);
    }
  }
  coverVoids();
  makeLevels();
}

void Survey::scan(const Raster& raster) {
  const auto columns = static_cast<std::size_t>(width_);
  const int together = raster.rowsTogether();
  const bool fits = columns * static_cast<std::size_t>(together) * sizeof(float) <= kBandBytes;
  const int bandRows = std::min(height_, fits ? std::max(together, kSquare) : kSquare);
  std::vector<float> band(columns * static_cast<std::size_t>(bandRows));
  std::vector<float> above(columns, kNone);      // the newest height of each column
  std::vector<std::int32_t> since(columns, -1);  // the row where its run of voids began, -1: none
  Bounds all = kNothing;
  double sum = 0;
  const auto requireRoom = [&] {
    if (rowRuns_.size() + columnRuns_.size() > kMostRuns)
      throw DataError(raster.name(), "voids", "there are more than a million gaps between heights");
  };
  for (int top = 0; top < height_; top += bandRows) {
    const int rows = std::min(bandRows, height_ - top);
    raster.read(0, top, width_, rows, band.data());
    for (int r = 0; r < rows; ++r) {
      const int row = top + r;
      const float* heights = band.data() + static_cast<std::size_t>(r) * columns;
      Bounds* squares = levels_[0].squares.data() + static_cast<std::size_t>(row / kSquare) *
                                                        static_cast<std::size_t>(levels_[0].columns);
      int began = -1;
      for (int column = 0; column < width_; ++column) {
        const auto c = static_cast<std::size_t>(column);
        const float height = heights[column];
        if (isVoid(height)) {
          ++voids_;
          if (began < 0) began = column;
          if (since[c] < 0) since[c] = row;
          continue;
        }
        sum += height;
        fold(squares[column / kSquare], height);
        if (began >= 0) {
          rowRuns_.push_back({row, began, column, began > 0 ? heights[began - 1] : kNone, height});
          began = -1;
        }
        if (since[c] >= 0) {
          columnRuns_.push_back({column, since[c], row, above[c], height});
          since[c] = -1;
        }
        above[c] = height;
      }
      if (began >= 0) rowRuns_.push_back({row, began, width_, began > 0 ? heights[began - 1] : kNone, kNone});
      requireRoom();
      if (row == 0) std::copy(heights, heights + width_, edges_[0].begin());
      if (row == height_ - 1) std::copy(heights, heights + width_, edges_[1].begin());
      edges_[2][static_cast<std::size_t>(row)] = heights[0];
      edges_[3][static_cast<std::size_t>(row)] = heights[width_ - 1];
    }
  }
  for (int column = 0; column < width_; ++column) {
    const auto c = static_cast<std::size_t>(column);
    if (since[c] >= 0) columnRuns_.push_back({column, since[c], height_, above[c], kNone});
  }
  requireRoom();
  for (const Bounds& square : levels_[0].squares) fold(all, square);
  const std::size_t count = columns * static_cast<std::size_t>(height_) - voids_;
  if (count == 0) throw DataError(raster.name(), "voids", "not one cell has a height");
  lowest_ = all.lowest;
  highest_ = all.highest;
  mean_ = sum / static_cast<double>(count);
}

// Where there are voids, what may fill them counts.
void Survey::coverVoids() {
  const auto mean = static_cast<float>(mean_);
  const auto cover = [&](const Run& run, bool isRow) {
    for (int place = run.first / kSquare; place <= (run.past - 1) / kSquare; ++place) {
      const int column = isRow ? place : run.line / kSquare, row = isRow ? run.line / kSquare : place;
      Bounds& square = levels_[0].squares[static_cast<std::size_t>(row) * levels_[0].columns + column];
      fold(square, run.before);
      fold(square, run.after);
      if (isVoid(run.before) && isVoid(run.after)) fold(square, mean);
    }
  };
  for (const Run& run : rowRuns_) cover(run, true);
  for (const Run& run : columnRuns_) cover(run, false);
}

void Survey::makeLevels() {
  while (levels_.back().columns > 1 || levels_.back().rows > 1) {
    const Level& fine = levels_.back();
    Level coarse{(fine.columns + 1) / 2, (fine.rows + 1) / 2, {}};
    coarse.squares.assign(static_cast<std::size_t>(coarse.columns) * coarse.rows, kNothing);
    for (int row = 0; row < fine.rows; ++row) {
      for (int column = 0; column < fine.columns; ++column)
        fold(coarse.squares[static_cast<std::size_t>(row / 2) * coarse.columns + column / 2],
             fine.squares[static_cast<std::size_t>(row) * fine.columns + column]);
    }
    levels_.push_back(std::move(coarse));
  }
}

const Survey::Run* Survey::runAt(const std::vector<Run>& runs, int line, int place) {
  const auto after = std::upper_bound(
      runs.begin(), runs.end(), std::pair(line, place),
      [](const std::pair<int, int>& at, const Run& run) { return at < std::pair(run.line, run.first); });
  if (after == runs.begin()) return nullptr;
  const Run& run = *std::prev(after);
  return run.line == line && place >= run.first && place < run.past ? &run : nullptr;
}

float Survey::filled(int column, int row) const {
  double sum = 0, weights = 0;
  const auto add = [&](float height, int distance) {
    if (isVoid(height)) return;
    const double weight = 1.0 / (static_cast<double>(distance) * distance);
    sum += weight * height;
    weights += weight;
  };
  const auto addRun = [&](const Run* run, int place) {
    if (run == nullptr) return;
    add(run->before, place - run->first + 1);
    add(run->after, run->past - place);
  };
  addRun(runAt(rowRuns_, row, column), column);
  addRun(runAt(columnRuns_, column, row), row);
  return static_cast<float>(weights > 0 ? sum / weights : mean_);
}

Bounds Survey::within(int column, int row, int lastColumn, int lastRow) const {
  int left = std::clamp(column, 0, width_ - 1) / kSquare,
      right = std::clamp(lastColumn, 0, width_ - 1) / kSquare;
  int top = std::clamp(row, 0, height_ - 1) / kSquare, bottom = std::clamp(lastRow, 0, height_ - 1) / kSquare;
  std::size_t level = 0;
  for (; level + 1 < levels_.size() && (right - left > 4 || bottom - top > 4); ++level) {
    left /= 2, right /= 2, top /= 2, bottom /= 2;
  }
  Bounds bounds = kNothing;
  for (int y = top; y <= bottom; ++y) {
    for (int x = left; x <= right; ++x)
      fold(bounds, levels_[level].squares[static_cast<std::size_t>(y) * levels_[level].columns + x]);
  }
  return bounds;
}

Bounds Survey::ofSurface() const {
  Bounds all = kNothing;
  for (int row = 0; row < height_; row += kSquare) {
    for (int column = 0; column < width_; column += kSquare) {
      const Bounds near = within(column - 2, row - 2, column + kSquare + 2, row + kSquare + 2);
      const float over = kOvershoot * (near.highest - near.lowest);
      fold(all, {near.lowest - over, near.highest + over});
    }
  }
  return all;
}

}  // namespace skydrop::elevation
