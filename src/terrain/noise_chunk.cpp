#include "terrain/noise_chunk.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

namespace skydrop::terrain {
namespace {

// One octave over the whole chunk: how its cells lie along the rows, and the nodes of the current row.
class ChunkOctave {
 public:
  ChunkOctave(const Lattice& lattice, double amplitude, const ChunkKey& key, const RowKernels& kernels)
      : lattice_(lattice),
        kernels_(kernels),
        originZ_(chunkOrigin(key).y),
        cellMetres_(cellMetres(key.level)) {
    // All exact: lattice cells and sample distances are powers of two, offsets multiples of 1/64.
    const double x = chunkOrigin(key).x / lattice.cell + lattice.offsetX;
    const double step = cellMetres_ / lattice.cell;  // cells from a sample to the next
    const double firstCell = std::floor(x);
    const double inCell = x - firstCell;
    firstNode_ = static_cast<std::int64_t>(firstCell);
    row_.perCell = step < 1 ? static_cast<int>(1 / step) : 1;
    row_.phase = step < 1 ? static_cast<int>(inCell / step) : 0;
    row_.cells = (kChunkSamples + row_.phase + row_.perCell - 1) / row_.perCell;
    nodeStride_ = step < 1 ? 1 : static_cast<std::int64_t>(step);

    // Of long cells only what the chunk covers is needed, but an index is cheaper than an offset.
    const int tableSize = std::min(row_.perCell, row_.phase + kChunkSamples);
    table_.resize(3 * static_cast<std::size_t>(tableSize));
    float* const u = table_.data();
    float* const fades = u + tableSize;
    float* const slopes = fades + tableSize;
    for (int k = 0; k < tableSize; ++k) {
      u[k] = static_cast<float>(inCell + (k - row_.phase) * step);
      fades[k] = fade(u[k]);
      slopes[k] = fadeSlope(u[k]);
    }
    row_.u = u;
    row_.fade = fades;
    row_.fadeSlope = slopes;
    row_.amplitude = static_cast<float>(kNoiseScale * amplitude);
    row_.perMetre = static_cast<float>(1 / lattice.cell);
    row_.carriesGradient = lattice.cell >= 2 * cellMetres_;
  }

  // Sets the row up; valid until the next call.
  const OctaveRow& at(int row) {
    const double z = (originZ_ + row * cellMetres_) / lattice_.cell + lattice_.offsetZ;
    const double cell = std::floor(z);
    const auto j = static_cast<std::int64_t>(cell);
    if (row == 0 || j != latticeRow_) enterLatticeRow(j, row == 0);
    row_.w = static_cast<float>(z - cell);
    row_.fadeZ = fade(row_.w);
    row_.fadeSlopeZ = fadeSlope(row_.w);
    return row_;
  }

 private:
  // Nodes of a lattice row. Where samples skip cells, the nodes east of them are not the next ones.
  struct Nodes {
    NodeRow west, east;
  };

  void fill(Nodes& nodes, std::int64_t j) const {
    const std::uint64_t seed = lattice_.rowSeed(j);
    const bool adjoining = nodeStride_ == 1;
    kernels_.nodes(seed, firstNode_, nodeStride_, row_.cells + (adjoining ? 1 : 0), nodes.west);
    if (!adjoining) kernels_.nodes(seed, firstNode_ + 1, nodeStride_, row_.cells, nodes.east);
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
      return nodeStride_ == 1 ? std::pair(n.west.x.data() + 1, n.west.z.data() + 1)
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
  double originZ_, cellMetres_;
  std::int64_t firstNode_ = 0, nodeStride_ = 1, latticeRow_ = 0;
  OctaveRow row_;
  std::vector<float> table_;
  std::unique_ptr<Nodes> north_ = std::make_unique<Nodes>(), south_ = std::make_unique<Nodes>();
};

std::vector<ChunkOctave> chunkOctaves(const std::vector<Lattice>& lattices, bool halving, const ChunkKey& key,
                                      const RowKernels& kernels) {
  std::vector<ChunkOctave> octaves;
  octaves.reserve(lattices.size());
  double amplitude = 1;
  for (const Lattice& lattice : lattices) {
    octaves.emplace_back(lattice, amplitude, key, kernels);
    if (halving) amplitude /= 2;
  }
  return octaves;
}

}  // namespace

bool fillNoiseChunk(const TerrainSettings& settings, const LandShape<float>& shape,
                    const LandOctaves& octaves, const RowKernels& kernels, const ChunkKey& key,
                    const std::stop_token& stop, ChunkData& out) {
  auto continent = chunkOctaves(octaves.continent, true, key, kernels);
  auto range = chunkOctaves(octaves.range, true, key, kernels);
  auto valley = chunkOctaves(octaves.valley, true, key, kernels);
  auto relief = chunkOctaves(octaves.relief, false, key, kernels);

  const auto state = std::make_unique<RowState>();
  const auto sum = [&](std::vector<ChunkOctave>& chain, int row, JetRow& field) {
    kernels.storeNoise(chain.front().at(row), field);
    for (std::size_t i = 1; i < chain.size(); ++i) kernels.addNoise(chain[i].at(row), field);
  };
  for (int row = 0; row < kChunkSamples; ++row) {
    if (stop.stop_requested()) return false;
    sum(continent, row, state->fields.continent);
    sum(range, row, state->fields.range);
    sum(valley, row, state->fields.valley);
    kernels.begin(shape, *state);
    for (std::size_t i = 0; i < relief.size(); ++i) {
      kernels.storeNoise(relief[i].at(row), state->noise);
      const int index = static_cast<int>(i);
      kernels.octave(shape, static_cast<float>(ridgeShare(settings, index)),
                     static_cast<float>(detailShare(settings, index)), *state);
    }
    const auto first = static_cast<std::size_t>(sampleIndex(0, row));
    kernels.finish(shape, *state, out.heights.data() + first, out.normals.data() + first);
  }
  return true;
}

}  // namespace skydrop::terrain
