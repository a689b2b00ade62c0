#include "terrain/noise_chunk.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

namespace skydrop::terrain {
namespace {

// Samples in rows: those of a chunk, or the nodes of a lattice of gullies. At most kRowSize a row.
struct SampleGrid {
  glm::dvec2 origin{};  // world position of the first, metres
  double step = 1;      // metres, a power of two
  int columns = 0, rows = 0;
  double gradientStep = 0;  // octaves with less than two of these a cell leave no gradient; 0: all do

  glm::dvec2 last() const { return origin + glm::dvec2(columns - 1, rows - 1) * step; }
};

// How the samples of a row lie in the cells of a lattice; the same for each row.
class CellTable {
 public:
  CellTable(const Lattice& lattice, const SampleGrid& grid) {
    // All exact: lattice cells and sample distances are powers of two, offsets multiples of 1/64.
    const double x = grid.origin.x / lattice.cell + lattice.offsetX;
    const double step = grid.step / lattice.cell;  // cells from a sample to the next
    const double firstCell = std::floor(x);
    const double inCell = x - firstCell;
    firstNode = static_cast<std::int64_t>(firstCell);
    nodeStride = step < 1 ? 1 : static_cast<std::int64_t>(step);
    row.perCell = step < 1 ? static_cast<int>(1 / step) : 1;
    row.phase = step < 1 ? static_cast<int>(inCell / step) : 0;
    row.cells = (grid.columns + row.phase + row.perCell - 1) / row.perCell;
    row.perMetre = static_cast<float>(1 / lattice.cell);

    // Of long cells only what the grid covers is needed, but an index is cheaper than an offset.
    const int size = std::min(row.perCell, row.phase + kRowSize);
    numbers_.resize(3 * static_cast<std::size_t>(size));
    float* const us = numbers_.data();
    float* const fades = us + size;
    float* const slopes = fades + size;
    for (int k = 0; k < size; ++k) {
      us[k] = static_cast<float>(inCell + (k - row.phase) * step);
      fades[k] = fade(us[k]);
      slopes[k] = fadeSlope(us[k]);
    }
    row.u = us;
    row.fade = fades;
    row.fadeSlope = slopes;
  }

  std::int64_t firstNode = 0, nodeStride = 1;
  RowInCells row;  // points into the table

 private:
  std::vector<float> numbers_;
};

// Where a row of samples lies between two rows of a lattice.
struct RowPlace {
  std::int64_t latticeRow;
  float w;
};
RowPlace placeOf(const Lattice& lattice, const SampleGrid& grid, int row) {
  const double z = (grid.origin.y + row * grid.step) / lattice.cell + lattice.offsetZ;
  const double cell = std::floor(z);
  return {static_cast<std::int64_t>(cell), static_cast<float>(z - cell)};
}

void enter(RowInCells& row, const RowPlace& place) {
  row.w = place.w;
  row.fadeZ = fade(place.w);
  row.fadeSlopeZ = fadeSlope(place.w);
}

// One octave of noise over a grid: how its cells lie along the rows, and the nodes of the current row.
class GridOctave {
 public:
  GridOctave(const Lattice& lattice, double amplitude, const SampleGrid& grid, const RowKernels& kernels)
      : lattice_(lattice), kernels_(kernels), grid_(grid), table_(lattice, grid) {
    static_cast<RowInCells&>(row_) = table_.row;
    row_.amplitude = static_cast<float>(kNoiseScale * amplitude);
    row_.carriesGradient = lattice.cell >= 2 * grid.gradientStep;
  }

  // Sets the row up; valid until the next call.
  const OctaveRow& at(int row) {
    const RowPlace place = placeOf(lattice_, grid_, row);
    if (row == 0 || place.latticeRow != latticeRow_) enterLatticeRow(place.latticeRow, row == 0);
    enter(row_, place);
    return row_;
  }

 private:
  // Nodes of a lattice row. Where samples skip cells, the nodes east of them are not the next ones.
  struct Nodes {
    NodeRow west, east;
  };

  void fill(Nodes& nodes, std::int64_t j) const {
    const std::uint64_t seed = lattice_.rowSeed(j);
    const bool adjoining = table_.nodeStride == 1;
    kernels_.nodes(seed, table_.firstNode, table_.nodeStride, row_.cells + (adjoining ? 1 : 0), nodes.west);
    if (!adjoining) kernels_.nodes(seed, table_.firstNode + 1, table_.nodeStride, row_.cells, nodes.east);
  }

  void enterLatticeRow(std::int64_t j, bool first) {
    if (!first && j == latticeRow_ + 1) {
      std::swap(north_, south_);
    } else {
      fill(*north_, j);
    }
    fill(*south_, j + 1);
    latticeRow_ = j;
    const auto east = [this](const Nodes& n) {
      return table_.nodeStride == 1 ? std::pair(n.west.x.data() + 1, n.west.z.data() + 1)
                                    : std::pair(n.east.x.data(), n.east.z.data());
    };
    row_.northWestX = north_->west.x.data();
    row_.northWestZ = north_->west.z.data();
    std::tie(row_.northEastX, row_.northEastZ) = east(*north_);
    row_.southWestX = south_->west.x.data();
    row_.southWestZ = south_->west.z.data();
    std::tie(row_.southEastX, row_.southEastZ) = east(*south_);
  }

  const Lattice& lattice_;
  const RowKernels& kernels_;
  SampleGrid grid_;
  CellTable table_;
  std::int64_t latticeRow_ = 0;
  OctaveRow row_;
  std::unique_ptr<Nodes> north_ = std::make_unique<Nodes>(), south_ = std::make_unique<Nodes>();
};

// A chain of octaves over a grid.
class GridChain {
 public:
  GridChain(const std::vector<Lattice>& lattices, const SampleGrid& grid, const RowKernels& kernels)
      : kernels_(kernels) {
    octaves_.reserve(lattices.size());
    double amplitude = 1;
    for (const Lattice& lattice : lattices) {
      octaves_.emplace_back(lattice, amplitude, grid, kernels);
      amplitude /= 2;
    }
  }
  void sum(int row, JetRow& out) {
    for (std::size_t i = 0; i < octaves_.size(); ++i)
      (i == 0 ? kernels_.storeNoise : kernels_.addNoise)(octaves_[i].at(row), out);
  }

 private:
  const RowKernels& kernels_;
  std::vector<GridOctave> octaves_;
};

// The land before water carves it: LandShape::begin over a grid.
class GridLand {
 public:
  GridLand(const LandShape<float>& shape, const LandOctaves& octaves, const SampleGrid& grid,
           const RowKernels& kernels)
      : shape_(shape),
        kernels_(kernels),
        continent_(octaves.continent, grid, kernels),
        range_(octaves.range, grid, kernels),
        crest_(octaves.crest, grid, kernels),
        valley_(octaves.valley, grid, kernels) {
    for (const Lattice& lattice : octaves.hills) hills_.emplace_back(lattice, 1.0, grid, kernels);
  }
  void begin(int row, RowState& state) {
    continent_.sum(row, state.fields.continent);
    range_.sum(row, state.fields.range);
    crest_.sum(row, state.fields.crest);
    valley_.sum(row, state.fields.valley);
    for (std::size_t i = 0; i < hills_.size(); ++i)
      kernels_.storeNoise(hills_[i].at(row), state.fields.hills[i]);
    kernels_.begin(shape_, state);
  }

 private:
  const LandShape<float>& shape_;
  const RowKernels& kernels_;
  GridChain continent_, range_, crest_, valley_;
  std::vector<GridOctave> hills_;
};

// The nodes of one octave of gullies, as far as a chunk needs them.
struct GullyNodes {
  SampleGrid grid;
  std::int64_t firstColumn = 0, firstRow = 0;
  std::vector<GullyNodeRow> rows;
};

// One octave of gullies over a grid that its nodes surround.
class GridGully {
 public:
  GridGully(const Lattice& lattice, double metres, const GullyNodes& nodes, const SampleGrid& grid,
            const RowKernels& kernels)
      : lattice_(lattice), kernels_(kernels), nodes_(nodes), grid_(grid), table_(lattice, grid) {
    static_cast<RowInCells&>(row_) = table_.row;
    row_.firstNode = static_cast<int>(table_.firstNode - nodes.firstColumn);
    row_.metres = static_cast<float>(metres);
    row_.carriesGradient = lattice.cell >= 2 * kGulliesPerCell * grid.gradientStep;
  }
  void carve(int row, RowState& state) {
    const RowPlace place = placeOf(lattice_, grid_, row);
    const auto north = static_cast<std::size_t>(place.latticeRow - nodes_.firstRow);
    row_.north = &nodes_.rows[north];
    row_.south = &nodes_.rows[north + 1];
    enter(row_, place);
    kernels_.gully(row_, state);
  }

 private:
  const Lattice& lattice_;
  const RowKernels& kernels_;
  const GullyNodes& nodes_;
  SampleGrid grid_;
  CellTable table_;
  GullyRow row_;
};

using AllGullyNodes = std::array<GullyNodes, kGullies.size()>;

std::vector<GridGully> gridGullies(const LandOctaves& octaves, const AllGullyNodes& nodes, std::size_t count,
                                   const SampleGrid& grid, const RowKernels& kernels) {
  std::vector<GridGully> gullies;
  gullies.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    gullies.emplace_back(octaves.gullies[i], kGullies[i].metres, nodes[i], grid, kernels);
  return gullies;
}

// The nodes around the samples of a chunk. Finer octaves are steered by the coarser ones at their own nodes,
// so each octave reaches around the nodes of the next finer one.
void fillGullyNodes(const LandShape<float>& shape, const LandOctaves& octaves, const RowKernels& kernels,
                    const SampleGrid& samples, RowState& state, AllGullyNodes& nodes) {
  glm::dvec2 lo = samples.origin, hi = samples.last();
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const Lattice& lattice = octaves.gullies[i];
    const glm::dvec2 offset{lattice.offsetX, lattice.offsetZ};
    const glm::dvec2 first = glm::floor(lo / lattice.cell + offset),
                     last = glm::floor(hi / lattice.cell + offset);
    GullyNodes& n = nodes[i];
    n.firstColumn = static_cast<std::int64_t>(first.x);
    n.firstRow = static_cast<std::int64_t>(first.y);
    n.grid = {(first - offset) * lattice.cell, lattice.cell, static_cast<int>(last.x - first.x) + 2,
              static_cast<int>(last.y - first.y) + 2, 0};
    lo = glm::min(lo, n.grid.origin);
    hi = glm::max(hi, n.grid.last());
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    GullyNodes& n = nodes[i];
    GridLand land(shape, octaves, n.grid, kernels);
    std::vector<GridGully> coarser = gridGullies(octaves, nodes, i, n.grid, kernels);
    n.rows.resize(static_cast<std::size_t>(n.grid.rows));
    for (int row = 0; row < n.grid.rows; ++row) {
      land.begin(row, state);
      for (GridGully& gully : coarser) gully.carve(row, state);
      kernels.gullyNodes(octaves.gullies[i].rowSeed(n.firstRow + row), n.firstColumn, n.grid.columns, state,
                         n.rows[static_cast<std::size_t>(row)]);
    }
  }
}

}  // namespace

bool fillNoiseChunk(const LandShape<float>& shape, const LandOctaves& octaves, const RowKernels& kernels,
                    const ChunkKey& key, const std::stop_token& stop, ChunkData& out,
                    std::vector<std::uint16_t>* wideHeights) {
  assert(out.heightRange == HeightRange{});  // what the kernels encode over
  if (stop.stop_requested()) return false;
  const double step = cellMetres(key.level);
  const int reach = normalReach(key.level), side = kChunkSamples + 2 * reach;
  const SampleGrid samples{chunkOrigin(key) - reach * step, step, side, side, step};
  const auto state = std::make_unique<RowState>();
  AllGullyNodes nodes;
  fillGullyNodes(shape, octaves, kernels, samples, *state, nodes);

  GridLand land(shape, octaves, samples, kernels);
  std::vector<GridGully> gullies = gridGullies(octaves, nodes, nodes.size(), samples, kernels);
  GridChain details(octaves.details, samples, kernels);
  std::array<std::uint16_t, kRowSize> heights;
  if (wideHeights != nullptr)
    wideHeights->resize(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  for (int row = 0; row < side; ++row) {
    if (stop.stop_requested()) return false;
    land.begin(row, *state);
    for (GridGully& gully : gullies) gully.carve(row, *state);
    details.sum(row, state->land.detail);
    const int chunkRow = row - reach;
    kernels.finish(shape, *state, side, heights.data(), out.normals.data() + normalIndex(-reach, chunkRow));
    if (wideHeights != nullptr) std::copy_n(heights.data(), side, wideHeights->data() + row * side);
    if (chunkRow < 0 || chunkRow >= kChunkSamples) continue;
    std::copy_n(heights.data() + reach, kChunkSamples, out.heights.data() + sampleIndex(0, chunkRow));
  }
  return true;
}

}  // namespace skydrop::terrain
