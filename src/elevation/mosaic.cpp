#include "elevation/mosaic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "elevation/bicubic.h"
#include "skydrop/core/error.h"

namespace skydrop::elevation {
namespace {

using core::DataError;

constexpr std::int64_t kRim = 1;  // cells of a page before its first

// The largest whole number not above it; of places on a lattice, which are far below 2^62.
inline std::int64_t floorOf(double value) {
  const auto whole = static_cast<std::int64_t>(value);
  return whole - (static_cast<double>(whole) > value ? 1 : 0);
}

// The part of the world around a tile set within which it counts.
WorldRect worldRectOf(const LocalPlane& plane, const Georeference& lattice, const std::vector<Tile>& tiles,
                      double blendM) {
  const Projection projection(lattice.crs, tiles[0].raster->name());
  WorldRect rect{{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()},
                 {std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()}};
  for (const Tile& tile : tiles) {
    constexpr int kSteps = 16;
    for (int i = 0; i <= kSteps; ++i) {
      for (int k = 0; k <= kSteps; ++k) {
        const double column =
            static_cast<double>(tile.column) - 0.5 + tile.raster->width() * i / double{kSteps};
        const double row = static_cast<double>(tile.row) - 0.5 + tile.raster->height() * k / double{kSteps};
        const auto place = projection.inverse(centreOf(lattice, column, row));
        if (!place) continue;
        const glm::dvec2 at = plane.positionOf(*place);
        rect.lo = {std::min(rect.lo.x, at.x), std::min(rect.lo.y, at.y)};
        rect.hi = {std::max(rect.hi.x, at.x), std::max(rect.hi.y, at.y)};
      }
    }
  }
  // The sides of a tile are curves in the world: between the places asked for they bulge by less than this.
  const double margin = blendM + 0.02 * std::max(rect.hi.x - rect.lo.x, rect.hi.y - rect.lo.y) + 8;
  rect.lo = {std::max(rect.lo.x - margin, -kFarthestM), std::max(rect.lo.y - margin, -kFarthestM)};
  rect.hi = {std::min(rect.hi.x + margin, kFarthestM), std::min(rect.hi.y + margin, kFarthestM)};
  if (!(rect.lo.x < rect.hi.x && rect.lo.y < rect.hi.y))
    throw DataError(tiles[0].raster->name(), "georeference",
                    "lies more than 500 km from the place that one flies over");
  return rect;
}

// The east coordinate in the middle of all tiles.
double middleOf(const Georeference& lattice, const std::vector<Tile>& tiles) {
  std::int64_t first = tiles[0].column, last = tiles[0].lastColumn();
  for (const Tile& tile : tiles) {
    first = std::min(first, tile.column);
    last = std::max(last, tile.lastColumn());
  }
  return centreOf(lattice, 0.5 * static_cast<double>(first + last), 0).x;
}

// The tiles as few rectangles: first those side by side in rows, then rows one upon the other.
std::vector<FadingBlock> blocksOf(const std::vector<Tile>& tiles, glm::dvec2 cellM, double fadeM) {
  std::vector<FadingBlock> blocks;
  for (const Tile& tile : tiles)
    blocks.push_back({static_cast<double>(tile.column) - 0.5, static_cast<double>(tile.row) - 0.5,
                      static_cast<double>(tile.lastColumn()) + 0.5, static_cast<double>(tile.lastRow()) + 0.5,
                      static_cast<float>(cellM.x), static_cast<float>(cellM.y), static_cast<float>(fadeM)});
  const auto merge = [&blocks](auto before, auto join) {
    std::sort(blocks.begin(), blocks.end(), before);
    std::vector<FadingBlock> merged;
    for (const FadingBlock& block : blocks) {
      if (merged.empty() || !join(merged.back(), block)) merged.push_back(block);
    }
    blocks = std::move(merged);
  };
  merge(
      [](const FadingBlock& a, const FadingBlock& b) {
        return std::tie(a.top, a.bottom, a.left, a.right) < std::tie(b.top, b.bottom, b.left, b.right);
      },
      [](FadingBlock& a, const FadingBlock& b) {
        if (a.top != b.top || a.bottom != b.bottom || b.left > a.right) return false;
        a.right = std::max(a.right, b.right);
        return true;
      });
  merge(
      [](const FadingBlock& a, const FadingBlock& b) {
        return std::tie(a.left, a.right, a.top, a.bottom) < std::tie(b.left, b.right, b.top, b.bottom);
      },
      [](FadingBlock& a, const FadingBlock& b) {
        if (a.left != b.left || a.right != b.right || b.top > a.bottom) return false;
        a.bottom = std::max(a.bottom, b.bottom);
        return true;
      });
  return blocks;
}

glm::dvec2 cellMetresOf(const Georeference& lattice, const std::vector<Tile>& tiles) {
  const Projection projection(lattice.crs, tiles[0].raster->name());
  if (!projection.isGeographic()) return lattice.cell;
  const Tile& tile = tiles[0];
  const double row = static_cast<double>(tile.row) + tile.raster->height() / 2.0;
  const double latitude = std::clamp(centreOf(lattice, 0, row).y, -89.5, 89.5);
  constexpr double kMetresPerDegree = 111320, kRadians = 0.017453292519943295;
  return {lattice.cell.x * kMetresPerDegree * std::cos(latitude * kRadians),
          lattice.cell.y * kMetresPerDegree};
}

}  // namespace

Mosaic::Mosaic(const LocalPlane& plane, Georeference lattice, std::vector<Tile> tiles, double blendM,
               std::size_t keptBytes)
    : lattice_(std::move(lattice)),
      tiles_(std::move(tiles)),
      blendM_(blendM),
      cellM_(cellMetresOf(lattice_, tiles_)),
      chart_(plane, lattice_, middleOf(lattice_, tiles_), worldRectOf(plane, lattice_, tiles_, blendM),
             tiles_[0].raster->name()),
      pages_(keptBytes) {
  blocks_ = blocksOf(tiles_, cellM_, std::max(blendM_, 1.0));
  surface_ = tiles_[0].survey->ofSurface();
  Bounds heights = tiles_[0].survey->all();
  double sum = 0, count = 0;
  for (const Tile& tile : tiles_) {
    const Bounds surface = tile.survey->ofSurface(), all = tile.survey->all();
    surface_ = {std::min(surface_.lowest, surface.lowest), std::max(surface_.highest, surface.highest)};
    heights = {std::min(heights.lowest, all.lowest), std::max(heights.highest, all.highest)};
    // Only what borders on the land around, not where tiles meet.
    const auto block = std::find_if(blocks_.begin(), blocks_.end(), [&](const FadingBlock& of) {
      return of.left < static_cast<double>(tile.column) &&
             of.right > static_cast<double>(tile.lastColumn()) && of.top < static_cast<double>(tile.row) &&
             of.bottom > static_cast<double>(tile.lastRow());
    });
    const auto countEdge = [&](bool isOuter, const std::vector<float>& edge) {
      if (!isOuter) return;
      for (const float height : edge) sum += height;
      count += static_cast<double>(edge.size());
    };
    countEdge(block->top + 0.5 == static_cast<double>(tile.row), tile.survey->north());
    countEdge(block->bottom - 0.5 == static_cast<double>(tile.lastRow()), tile.survey->south());
    countEdge(block->left + 0.5 == static_cast<double>(tile.column), tile.survey->west());
    countEdge(block->right - 0.5 == static_cast<double>(tile.lastColumn()), tile.survey->east());
  }
  // Where tiles meet, one's heights stand beside the other's.
  if (tiles_.size() > 1) {
    const float over = Survey::kOvershoot * (heights.highest - heights.lowest);
    surface_ = {std::min(surface_.lowest, heights.lowest - over),
                std::max(surface_.highest, heights.highest + over)};
  }
  meanOfEdges_ = sum / count;
}

std::vector<const Tile*> Mosaic::tilesNear(const CellRect& rect, double reachCells) const {
  std::vector<const Tile*> near;
  for (const Tile& tile : tiles_) {
    if (static_cast<double>(tile.column) <= rect.right + reachCells &&
        static_cast<double>(tile.lastColumn()) >= rect.left - reachCells &&
        static_cast<double>(tile.row) <= rect.bottom + reachCells &&
        static_cast<double>(tile.lastRow()) >= rect.top - reachCells)
      near.push_back(&tile);
  }
  return near;
}

void Mosaic::wake(const Tile& tile) const {
  const Tile* tired = nullptr;
  {
    const std::scoped_lock lock(mutex_);
    if (!awake_.empty() && awake_.front() == &tile) return;
    std::erase(awake_, &tile);
    awake_.insert(awake_.begin(), &tile);
    if (awake_.size() > kAwake) {
      tired = awake_.back();
      awake_.pop_back();
    }
  }
  if (tired != nullptr) tired->raster->rest();
}

std::size_t Mosaic::keptBytes() const {
  const std::scoped_lock lock(mutex_);
  std::size_t bytes = pages_.statistics().bytes;
  for (const Tile& tile : tiles_) bytes += tile.raster->heldBytes();
  return bytes;
}

std::uint64_t Mosaic::faults() const {
  const std::scoped_lock lock(mutex_);
  return faults_;
}

std::shared_ptr<const Page> Mosaic::pageAt(std::int64_t column, std::int64_t row) const {
  const glm::i64vec2 key{column, row};
  {
    const std::scoped_lock lock(mutex_);
    if (const auto* kept = pages_.find(key)) return *kept;
  }
  std::shared_ptr<const Page> page = makePage(column, row);
  const std::scoped_lock lock(mutex_);
  pages_.insert(key, page, page->heights.size() * sizeof(float));
  return page;
}

// The first tile with a height has it; after all of them, a void is filled by the first tile that covers it.
void Mosaic::readTiles(const std::vector<const Tile*>& tiles, std::int64_t left, std::int64_t top,
                       Page& page) const {
  std::vector<float> part;
  for (const Tile* tile : tiles) {
    const std::int64_t x0 = std::max(left, tile->column),
                       x1 = std::min(left + Page::kSide - 1, tile->lastColumn());
    const std::int64_t y0 = std::max(top, tile->row), y1 = std::min(top + Page::kSide - 1, tile->lastRow());
    if (x0 > x1 || y0 > y1) continue;
    const int columns = static_cast<int>(x1 - x0 + 1), rows = static_cast<int>(y1 - y0 + 1);
    part.resize(static_cast<std::size_t>(columns) * rows);
    wake(*tile);
    try {
      tile->raster->read(static_cast<int>(x0 - tile->column), static_cast<int>(y0 - tile->row), columns, rows,
                         part.data());
    } catch (const DataError&) {
      // The file was whole when the flight began: fly on, over something flat.
      std::fill(part.begin(), part.end(), static_cast<float>(tile->survey->mean()));
      const std::scoped_lock lock(mutex_);
      ++faults_;
    }
    for (int r = 0; r < rows; ++r) {
      float* out = page.heights.data() + (y0 - top + r) * Page::kSide + (x0 - left);
      const float* in = part.data() + static_cast<std::size_t>(r) * columns;
      for (int c = 0; c < columns; ++c) {
        if (out[c] != out[c]) out[c] = in[c];
      }
    }
  }
  for (const Tile* tile : tiles) {
    if (tile->survey->voids() == 0) continue;
    for (std::int64_t y = std::max(top, tile->row); y <= std::min(top + Page::kSide - 1, tile->lastRow());
         ++y) {
      for (std::int64_t x = std::max(left, tile->column);
           x <= std::min(left + Page::kSide - 1, tile->lastColumn()); ++x) {
        float& height = page.heights[static_cast<std::size_t>((y - top) * Page::kSide + (x - left))];
        if (height != height)
          height = tile->survey->filled(static_cast<int>(x - tile->column), static_cast<int>(y - tile->row));
      }
    }
  }
}

namespace {

// What lies beside tiles is taken for the mean of the nearest edges to the four sides, weighted by (1/d -
// 1/reach)^2; beyond the corners of all of them it is the nearest corner. What is further than `reach` cells
// does not count, so that a cell is the same in every page, whatever tiles each has near.
float besideTiles(const std::vector<const Tile*>& tiles, std::int64_t x, std::int64_t y, double reach) {
  struct Side {
    std::int64_t distance = std::numeric_limits<std::int64_t>::max();
    float height = 0;
    void offer(std::int64_t away, float value) {
      if (away < distance) *this = {away, value};
    }
  };
  Side west, east, north, south, corner;
  for (const Tile* tile : tiles) {
    const Survey& survey = *tile->survey;
    const std::int64_t nearX = std::clamp(x, tile->column, tile->lastColumn());
    const std::int64_t nearY = std::clamp(y, tile->row, tile->lastRow());
    const auto column = static_cast<std::size_t>(nearX - tile->column);
    const auto row = static_cast<std::size_t>(nearY - tile->row);
    if (nearY == y) {
      if (nearX < x)
        west.offer(x - nearX, survey.east()[row]);
      else
        east.offer(nearX - x, survey.west()[row]);
    } else if (nearX == x) {
      if (nearY < y)
        north.offer(y - nearY, survey.south()[column]);
      else
        south.offer(nearY - y, survey.north()[column]);
    } else {
      const std::int64_t dx = nearX - x, dy = nearY - y;
      corner.offer(dx * dx + dy * dy, nearY < y ? survey.south()[column] : survey.north()[column]);
    }
  }
  double sum = 0, weights = 0;
  for (const Side* side : {&west, &east, &north, &south}) {
    if (side->distance == std::numeric_limits<std::int64_t>::max()) continue;
    const double near = 1.0 / static_cast<double>(side->distance) - 1.0 / reach;
    if (!(near > 0)) continue;
    sum += near * near * side->height;
    weights += near * near;
  }
  return weights > 0 ? static_cast<float>(sum / weights) : corner.height;
}

}  // namespace

std::shared_ptr<const Page> Mosaic::makePage(std::int64_t column, std::int64_t row) const {
  auto page = std::make_shared<Page>();
  page->heights.assign(static_cast<std::size_t>(Page::kSide) * Page::kSide,
                       std::numeric_limits<float>::quiet_NaN());
  const std::int64_t left = column * Page::kCells - kRim, top = row * Page::kCells - kRim;
  const CellRect cells{static_cast<double>(left), static_cast<double>(top),
                       static_cast<double>(left + Page::kSide - 1),
                       static_cast<double>(top + Page::kSide - 1)};
  readTiles(tilesNear(cells, 0), left, top, *page);
  std::vector<const Tile*> beside;
  constexpr double kAround = 4;  // cells of a patch, which may lie beyond the place that counts
  const double reach = blendM_ / cellM() + kAround;
  for (int r = 0; r < Page::kSide; ++r) {
    for (int c = 0; c < Page::kSide; ++c) {
      float& height = page->heights[static_cast<std::size_t>(r) * Page::kSide + c];
      if (height == height) continue;
      if (beside.empty()) beside = tilesNear(cells, reach + Page::kSide);
      height = besideTiles(beside, left + c, top + r, reach);
    }
  }
  return page;
}

namespace {

// Cells between a place and a block, 0 on it.
glm::dvec2 outside(const FadingBlock& block, glm::dvec2 at) {
  const auto axis = [](double value, double first, double last) {
    return value < first ? value - first : value > last ? value - last : 0.0;
  };
  return {axis(at.x, block.left, block.right), axis(at.y, block.top, block.bottom)};
}

// As SurfaceKernels::fade, in double.
double weightAt(const std::vector<FadingBlock>& blocks, const Chart::Spot& spot, glm::dvec2& gradient) {
  double rest = 1;
  glm::dvec2 slope{};  // of the rest, a cell
  for (const FadingBlock& block : blocks) {
    const glm::dvec2 cellM(block.cellEastM, block.cellSouthM);
    const glm::dvec2 away = outside(block, spot.at) * cellM;
    const double t = std::sqrt(away.x * away.x + away.y * away.y) / block.fadeM;
    if (t == 0) return 1;
    if (t >= 1) continue;
    const double step = t * t * (3 - 2 * t);
    slope = slope * step + rest * 6 * (1 - t) / (block.fadeM * block.fadeM) * away * cellM;
    rest *= step;
  }
  gradient =
      -glm::dvec2(slope.x * spot.dx.x + slope.y * spot.dx.y, slope.x * spot.dz.x + slope.y * spot.dz.y);
  return 1 - rest;
}

}  // namespace

Mosaic::Sample Mosaic::at(glm::dvec2 xz) const {
  const Chart::Spot spot = Chart::Row(chart_, xz.y).at(xz.x);
  if (!spot.isValid) return {};
  Sample sample;
  sample.weight = weightAt(blocks_, spot, sample.weightGradient);
  if (!(sample.weight > 0)) return {};
  const std::int64_t i = floorOf(spot.at.x), k = floorOf(spot.at.y);
  const std::int64_t pageColumn = i >> 7, pageRow = k >> 7;  // floors
  static_assert(Page::kCells == 1 << 7);
  const std::shared_ptr<const Page> page = pageAt(pageColumn, pageRow);
  const float* cells = page->patch(static_cast<int>(i - pageColumn * Page::kCells),
                                   static_cast<int>(k - pageRow * Page::kCells));
  const Patch<float> patch =
      surfaceAt(cells, Page::kSide, static_cast<float>(spot.at.x - static_cast<double>(i)),
                static_cast<float>(spot.at.y - static_cast<double>(k)));
  sample.height = patch.height;
  const double across = patch.acrossSlope, down = patch.downSlope;
  sample.gradient = {across * spot.dx.x + down * spot.dx.y, across * spot.dz.x + down * spot.dz.y};
  return sample;
}

std::optional<std::vector<FadingBlock>> Mosaic::blocksNear(const CellRect& rect) const {
  std::vector<FadingBlock> near;
  for (const FadingBlock& block : blocks_) {
    if (rect.left >= block.left && rect.right <= block.right && rect.top >= block.top &&
        rect.bottom <= block.bottom)
      return std::nullopt;
    const double east = block.fadeM / block.cellEastM, south = block.fadeM / block.cellSouthM;
    if (rect.right >= block.left - east && rect.left <= block.right + east &&
        rect.bottom >= block.top - south && rect.top <= block.bottom + south)
      near.push_back(block);
  }
  return near;
}

std::optional<Mosaic::CellRect> Mosaic::cellsOf(const WorldRect& rect) const {
  constexpr int kSteps = 4;
  CellRect cells{1e300, 1e300, -1e300, -1e300};
  bool isWhole = true;
  for (int r = 0; r <= kSteps; ++r) {
    Chart::Row row(chart_, rect.lo.y + (rect.hi.y - rect.lo.y) * r / kSteps);
    for (int c = 0; c <= kSteps; ++c) {
      const Chart::Spot spot = row.at(rect.lo.x + (rect.hi.x - rect.lo.x) * c / kSteps);
      if (!spot.isValid) {
        isWhole = false;
        continue;
      }
      cells = {std::min(cells.left, spot.at.x), std::min(cells.top, spot.at.y),
               std::max(cells.right, spot.at.x), std::max(cells.bottom, spot.at.y)};
    }
  }
  if (!isWhole) return std::nullopt;
  // Straight lines of the world are curves here, which bulge between the places asked for.
  const double bulge = 2 + 0.02 * std::max(cells.right - cells.left, cells.bottom - cells.top);
  return CellRect{cells.left - bulge, cells.top - bulge, cells.right + bulge, cells.bottom + bulge};
}

std::optional<Bounds> Mosaic::bounds(const WorldRect& rect) const {
  const std::optional<CellRect> cells = cellsOf(rect);
  if (!cells || chart_.isExact() || rect.hi.x - rect.lo.x > 1e5 || rect.hi.y - rect.lo.y > 1e5) {
    // Partly beyond the chart, or so large that it does not matter: all of it, if it is touched at all.
    return chart_.touches(rect) ? std::optional(surface_) : std::nullopt;
  }
  const double reach = blendM_ / cellM() + 2.0 * Page::kSide;
  const std::vector<const Tile*> near = tilesNear(*cells, reach);
  if (near.empty()) return std::nullopt;
  bool isInside = false;
  Bounds all{std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest()};
  for (const Tile* tile : near) {
    const auto c = static_cast<double>(tile->column), r = static_cast<double>(tile->row);
    isInside = isInside || (cells->left - 2 >= c && cells->top - 2 >= r &&
                            cells->right + 2 <= static_cast<double>(tile->lastColumn()) &&
                            cells->bottom + 2 <= static_cast<double>(tile->lastRow()));
  }
  for (const Tile* tile : near) {
    const auto clamped = [](double value) { return static_cast<int>(std::clamp(value, -1e9, 1e9)); };
    Bounds of = tile->survey->all();
    if (isInside) {
      const auto c = static_cast<double>(tile->column), r = static_cast<double>(tile->row);
      if (cells->right + 2 < c || cells->left - 2 > static_cast<double>(tile->lastColumn()) ||
          cells->bottom + 2 < r || cells->top - 2 > static_cast<double>(tile->lastRow()))
        continue;
      of = tile->survey->within(clamped(cells->left - 2 - c), clamped(cells->top - 2 - r),
                                clamped(cells->right + 2 - c), clamped(cells->bottom + 2 - r));
    }
    all = {std::min(all.lowest, of.lowest), std::max(all.highest, of.highest)};
  }
  const float over = Survey::kOvershoot * (all.highest - all.lowest);
  return Bounds{all.lowest - over, all.highest + over};
}

bool Mosaic::covers(const WorldRect& rect) const {
  if (chart_.isExact()) return false;
  const std::optional<CellRect> cells = cellsOf(rect);
  if (!cells) return false;
  return !blocksNear(*cells);
}

std::vector<std::unique_ptr<Mosaic>> makeMosaics(const LocalPlane& plane,
                                                 const std::vector<std::shared_ptr<const Raster>>& rasters,
                                                 double blendM) {
  struct Group {
    Georeference lattice;
    std::vector<Tile> tiles;
    bool isGeographic;
    double fineness;
  };
  std::vector<Group> groups;
  for (const auto& raster : rasters) {
    Georeference place = raster->georeference();
    const bool geographic = isGeographic(place.crs, raster->name());
    // Tiles on both sides of the date line become neighbours.
    if (geographic) {
      const double middle = place.first.x + place.cell.x * raster->width() / 2;
      place.first.x += turnedNear(middle, plane.origin().longitude) - middle;
    }
    Tile tile{raster, std::make_shared<const Survey>(*raster), 0, 0};
    raster->rest();
    bool isPlaced = false;
    for (Group& group : groups) {
      const glm::dvec2 at = (place.first - group.lattice.first) / group.lattice.cell;
      const glm::dvec2 whole{std::round(at.x), std::round(-at.y)};
      const auto isSame = [](double a, double b, double cells) { return std::abs(a - b) * cells < 0.01 * b; };
      constexpr double kOffLattice = 0.01;  // of a cell
      if (group.lattice.crs != place.crs || !isSame(place.cell.x, group.lattice.cell.x, raster->width()) ||
          !isSame(place.cell.y, group.lattice.cell.y, raster->height()) ||
          std::abs(at.x - whole.x) > kOffLattice || std::abs(-at.y - whole.y) > kOffLattice ||
          std::abs(whole.x) > 1e8 || std::abs(whole.y) > 1e8)
        continue;
      tile.column = static_cast<std::int64_t>(whole.x);
      tile.row = static_cast<std::int64_t>(whole.y);
      group.tiles.push_back(tile);
      isPlaced = true;
      break;
    }
    if (!isPlaced)
      groups.push_back({place, {tile}, geographic, geographic ? place.cell.y * 111320 : place.cell.y});
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const Group& a, const Group& b) { return a.fineness < b.fineness; });
  std::vector<std::unique_ptr<Mosaic>> mosaics;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    // Over coarser data the finer ones fade within a few of their cells.
    constexpr double kCellsBetween = 10;
    const double width =
        i + 1 < groups.size() ? std::min(blendM, kCellsBetween * groups[i + 1].fineness) : blendM;
    mosaics.push_back(std::make_unique<Mosaic>(plane, groups[i].lattice, std::move(groups[i].tiles), width,
                                               Mosaic::kKeptBytes / groups.size()));
  }
  return mosaics;
}

}  // namespace skydrop::elevation
