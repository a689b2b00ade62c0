// Tiles of one reference system and cell size whose cells lie on one lattice: one land, without seams.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "elevation/chart.h"
#include "elevation/surface_kernels.h"
#include "skydrop/core/hash.h"
#include "skydrop/core/lru_cache.h"
#include "skydrop/elevation/survey.h"

namespace skydrop::elevation {

struct Tile {
  std::shared_ptr<const Raster> raster;
  std::shared_ptr<const Survey> survey;
  std::int64_t column = 0, row = 0;  // of its first cell in the lattice

  std::int64_t lastColumn() const { return column + raster->width() - 1; }
  std::int64_t lastRow() const { return row + raster->height() - 1; }
};

// A square of the lattice with a rim.
struct Page {
  static constexpr int kCells = kPageCells, kSide = kPageSide;
  std::vector<float> heights;  // row-major

  // The 4 x 4 cells around the cell (column, row) of the page.
  const float* patch(int column, int row) const { return heights.data() + row * kSide + column; }
};

// Immutable but for what it keeps in memory; any thread.
class Mosaic {
 public:
  // Cells of pages that are kept, over all mosaics: 32 MiB. Rasters that keep what they have unpacked: the
  // newest kAwake.
  static constexpr std::size_t kKeptBytes = std::size_t{32} << 20;
  static constexpr std::size_t kAwake = 4;

  // `blendM`: over which distance beyond its tiles it fades, >= 0.
  Mosaic(const LocalPlane& plane, Georeference lattice, std::vector<Tile> tiles, double blendM,
         std::size_t keptBytes);

  // Height, gradient (a metre east, south), and how much of the land is this: 1 on its tiles, 0 beyond the
  // distance over which it fades; with its gradient.
  struct Sample {
    double height = 0, weight = 0;
    glm::dvec2 gradient{}, weightGradient{};
  };

  Sample at(glm::dvec2 xz) const;

  // Conservative bounds of the heights of samples in the rectangle whose weight is above 0; nothing where
  // none is.
  std::optional<Bounds> bounds(const WorldRect& rect) const;
  Bounds ofSurface() const { return surface_; }
  // Whether all samples in the rectangle have weight 1.
  bool covers(const WorldRect& rect) const;

  const std::vector<Tile>& tiles() const { return tiles_; }
  double meanOfEdges() const { return meanOfEdges_; }
  double cellM() const { return std::min(cellM_.x, cellM_.y); }
  // Bytes that pages and rasters hold now.
  std::size_t keptBytes() const;
  // Pages that could not be read since the start; their tile's mean is shown.
  std::uint64_t faults() const;

 private:
  friend class RowReader;

  // Places on the lattice, last ones included.
  struct CellRect {
    double left, top, right, bottom;
  };

  std::optional<CellRect> cellsOf(const WorldRect& rect) const;
  // Blocks within whose fading a place of the rectangle lies; nothing where one of them holds all of it.
  std::optional<std::vector<FadingBlock>> blocksNear(const CellRect& rect) const;
  std::shared_ptr<const Page> pageAt(std::int64_t column, std::int64_t row) const;
  std::shared_ptr<const Page> makePage(std::int64_t column, std::int64_t row) const;
  void readTiles(const std::vector<const Tile*>& tiles, std::int64_t left, std::int64_t top,
                 Page& page) const;
  void wake(const Tile& tile) const;
  std::vector<const Tile*> tilesNear(const CellRect& rect, double reachCells) const;

  Georeference lattice_;
  std::vector<Tile> tiles_;
  std::vector<FadingBlock> blocks_;  // all tiles: those that lie side by side are one block
  double blendM_;
  glm::dvec2 cellM_{};  // of a cell, in the middle of the tiles
  Chart chart_;
  Bounds surface_{};
  double meanOfEdges_ = 0;

  struct PageHash {
    std::size_t operator()(const glm::i64vec2& key) const noexcept {
      return core::hashCombine(static_cast<std::uint64_t>(key.x), static_cast<std::uint64_t>(key.y));
    }
  };
  mutable std::mutex mutex_;  // of all below
  mutable core::LRUCache<glm::i64vec2, std::shared_ptr<const Page>, PageHash> pages_;
  mutable std::vector<const Tile*> awake_;
  mutable std::uint64_t faults_ = 0;
};

// Sorts tiles into mosaics, the finest first. Throws core::DataError: a tile that lies too far from the
// plane's origin to be flown over (kFarthestM), or cannot be read.
inline constexpr double kFarthestM = 500e3;
std::vector<std::unique_ptr<Mosaic>> makeMosaics(const LocalPlane& plane,
                                                 const std::vector<std::shared_ptr<const Raster>>& rasters,
                                                 double blendM);

}  // namespace skydrop::elevation
