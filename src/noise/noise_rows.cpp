#include "noise/noise_rows.h"

#include <algorithm>
#include <utility>

#include "skydrop/core/shared.h"

namespace skydrop::noise {
namespace {

namespace shared = core::shared::f32;

std::uint32_t word(int value) { return static_cast<std::uint32_t>(value); }

// A texel's place along one axis of a lattice.
struct PlaceInCells {
  std::uint32_t cell = 0, next = 0;
  float inside = 0;
};

PlaceInCells placeOf(int texel, int side, std::uint32_t cells) {
  const glm::u32vec2 at = shared::cellOfTexel(word(texel), word(side), cells);
  return {at.x, shared::cellAfter(at.x, cells), static_cast<float>(at.y) * (0.5f / static_cast<float>(side))};
}

// Whether all texels lie on points of the lattice, where noise is 0: so it is with octaves whose frequency is
// a multiple of twice the side.
bool liesOnNodes(int side, std::uint32_t cells) { return cells % (2 * word(side)) == 0; }

}  // namespace

// What fill() works in: the nodes of a lattice row, and two lattice rows with their coordinates.
struct NoiseRows::Scratch {
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};  // beyond the finest lattice
  struct Row {
    std::uint32_t coordinate = kNone;
    std::vector<float> value, slope;
    LatticeRow view() { return {value.data(), slope.data()}; }
  };

  explicit Scratch(std::size_t width)
      : nodes(3 * 2 * width),
        expanded(6 * width),
        rows{Row{kNone, std::vector<float>(width), std::vector<float>(width)},
             Row{kNone, std::vector<float>(width), std::vector<float>(width)}} {}

  std::vector<float> nodes, expanded;
  Row rows[2];
};

RowInCells NoiseRows::Octave::row() const {
  return {static_cast<int>(inside.size()),
          static_cast<int>(columns.size()),
          columns.data(),
          west.empty() ? nullptr : west.data(),
          east.empty() ? nullptr : east.data(),
          inside.data(),
          fade.data()};
}

NoiseRows::NoiseRows(const NoiseSettings& settings, const NoiseSize& size, const OctaveKernels& kernels)
    : size_(size), kernels_(kernels) {
  auto weight = static_cast<float>(settings.amplitude);
  auto cells = static_cast<std::uint32_t>(settings.frequency);
  const std::uint32_t dimensions = size.isVolume() ? 3 : 2;
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(settings.octaves); ++i) {
    const bool vanishes = liesOnNodes(size.width, cells) && liesOnNodes(size.height, cells) &&
                          (!size.isVolume() || liesOnNodes(size.slices, cells));
    if (!vanishes) {
      Octave octave;
      octave.cells = cells;
      octave.salt = shared::octaveSalt(static_cast<std::uint32_t>(settings.seed), i, dimensions);
      octave.weight = weight;
      place(octave, size.width);
      octaves_.push_back(std::move(octave));
    }
    weight *= static_cast<float>(settings.persistence);
    cells *= 2;
  }
}

// All columns of the lattice, looked up by texel; or where they are many, two for each texel.
void NoiseRows::place(Octave& octave, int width) {
  const bool shares = octave.cells <= word(width) / 2;
  std::vector<std::uint32_t> eastern;
  for (std::uint32_t column = 0; shares && column < octave.cells; ++column)
    octave.columns.push_back(column * shared::kColumnStride);
  for (int x = 0; x < width; ++x) {
    const PlaceInCells at = placeOf(x, width, octave.cells);
    if (shares) {
      octave.west.push_back(at.cell);
      octave.east.push_back(at.next);
    } else {
      octave.columns.push_back(at.cell * shared::kColumnStride);
      eastern.push_back(at.next * shared::kColumnStride);
    }
    octave.inside.push_back(at.inside);
    octave.fade.push_back(shared::smoothStep5(at.inside));
  }
  octave.columns.insert(octave.columns.end(), eastern.begin(), eastern.end());
}

void NoiseRows::fill(int layer, int firstRow, std::span<float> values) const {
  std::fill(values.begin(), values.end(), 0.0f);
  Scratch scratch(static_cast<std::size_t>(size_.width));
  for (const Octave& octave : octaves_) add(octave, layer, firstRow, values, scratch);
  kernels_.finish(static_cast<int>(values.size()), values.data());
}

void NoiseRows::add(const Octave& octave, int layer, int firstRow, std::span<float> values,
                    Scratch& scratch) const {
  const RowInCells texels = octave.row();
  const NodeRow nodes{scratch.nodes.data(), scratch.nodes.data() + texels.nodes,
                      size_.isVolume() ? scratch.nodes.data() + 2 * texels.nodes : nullptr};
  const PlaceInCells z = size_.isVolume() ? placeOf(layer, size_.slices, octave.cells) : PlaceInCells{};
  const auto make = [&](std::uint32_t coordinate, Scratch::Row& row) {
    if (row.coordinate == coordinate) return;
    row.coordinate = coordinate;
    const std::uint32_t start = coordinate * shared::kRowStride + octave.salt;
    if (size_.isVolume()) {
      kernels_.spaceNodes(texels, start + z.cell * shared::kSliceStride,
                          start + z.next * shared::kSliceStride, z.inside, nodes);
    } else {
      kernels_.planeNodes(texels, start, nodes);
    }
    kernels_.alongRow(texels, nodes, scratch.expanded.data(), row.view());
  };
  for (Scratch::Row& row : scratch.rows) row.coordinate = Scratch::kNone;
  const auto width = static_cast<std::size_t>(size_.width);
  for (std::size_t i = 0; i < values.size() / width; ++i) {
    const PlaceInCells y = placeOf(firstRow + static_cast<int>(i), size_.height, octave.cells);
    if (scratch.rows[1].coordinate == y.cell) std::swap(scratch.rows[0], scratch.rows[1]);
    make(y.cell, scratch.rows[0]);
    make(y.next, scratch.rows[1]);
    kernels_.addRow(size_.width, scratch.rows[0].view(), scratch.rows[1].view(), y.inside, octave.weight,
                    values.data() + i * width);
  }
}

}  // namespace skydrop::noise
