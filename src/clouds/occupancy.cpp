#include "skydrop/clouds/occupancy.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>

#include "skydrop/core/shared_clouds.h"

namespace skydrop::clouds {
namespace {

namespace f32 = core::shared::f32;

constexpr int kSide = Occupancy::kSide, kRows = Occupancy::kRows;

// Added to all that a cell holds, in full scale of the textures: what a lookup in 32 bits, or by a filter
// that knows 1/256 of a texel only, may fetch from beyond the cell's border.
constexpr float kSlack = 1.0f / 256;

// The texels that filtering may touch in one cell, along one axis: two runs of a common length, a power
// of two, that cover them.
struct Window {
  std::size_t first, second;
};

struct Windows {
  std::size_t side;    // texels until they repeat, a power of two
  std::size_t length;  // of a run
  std::vector<Window> cells;
};

// `count` cells of so many texels each, the first beginning at a texel coordinate (texels are centred on
// whole numbers), each with some texels more on both sides.
Windows windowsOf(int side, int count, double begin, double texelsPerCell, double more = 0) {
  Windows windows{static_cast<std::size_t>(side), 1, {}};
  const std::int64_t wrap = side - 1;
  const auto texelsOf = [&](int cell) {
    const double from = std::floor(begin + cell * texelsPerCell - more),
                 to = std::ceil(begin + (cell + 1) * texelsPerCell + more);
    return std::array{static_cast<std::int64_t>(from), static_cast<std::int64_t>(to)};
  };
  // Lengths of the cells of one axis differ by one at most, so the longest power of two that fits the
  // shortest covers half of the longest.
  std::int64_t shortest = side;
  for (int cell = 0; cell < count; ++cell) {
    const auto [from, to] = texelsOf(cell);
    shortest = std::min(shortest, to - from + 1);
  }
  windows.length = std::bit_floor(static_cast<std::size_t>(shortest));
  for (int cell = 0; cell < count; ++cell) {
    const auto [from, to] = texelsOf(cell);
    const std::int64_t second = to + 1 - static_cast<std::int64_t>(windows.length);
    windows.cells.push_back({static_cast<std::size_t>(from & wrap), static_cast<std::size_t>(second & wrap)});
  }
  return windows;
}

// into[i] = max(a[i], b[i]); may be one of them.
void maxima(const float* a, const float* b, float* into, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) into[i] = a[i] < b[i] ? b[i] : a[i];
}

// Maximum over each window, along lines that stand one after the other in memory: `side` texels become as
// many as there are cells.
void maximaAlong(const Windows& windows, const float* lines, std::size_t count, float* into) {
  const std::size_t side = windows.side;
  std::vector<float> line(2 * side);
  for (std::size_t k = 0; k < count; ++k, lines += side) {
    std::copy_n(lines, side, line.begin());
    std::copy_n(lines, side, line.begin() + static_cast<std::ptrdiff_t>(side));
    for (std::size_t reach = 1; reach < windows.length; reach *= 2) {
      maxima(line.data(), line.data() + reach, line.data(), 2 * side - reach);
    }
    for (const Window& window : windows.cells) *into++ = std::max(line[window.first], line[window.second]);
  }
}

// Maximum over each window, across `side` lines of a length: they become as many lines as there are cells.
void maximaAcross(const Windows& windows, const float* lines, std::size_t length, float* into) {
  const std::size_t side = windows.side;
  std::vector<float> reached(lines, lines + side * length), next(windows.length > 1 ? side * length : 0);
  for (std::size_t reach = 1; reach < windows.length; reach *= 2) {
    for (std::size_t k = 0; k < side; ++k) {
      maxima(&reached[k * length], &reached[((k + reach) & (side - 1)) * length], &next[k * length], length);
    }
    reached.swap(next);
  }
  for (const Window& window : windows.cells) {
    maxima(&reached[window.first * length], &reached[window.second * length], into, length);
    into += length;
  }
}

// Largest base density of each cell, at (z * kRows + row) * kSide + x.
std::vector<float> largestBase(const PackedCloudNoise& noise, const LayerMedium& medium,
                               double weatherPeriodM, double heightSlackM) {
  const CloudLayerSettings& layer = medium.layer;
  const glm::dvec3& stretch = medium.form.stretch;
  const int side = noise.shapeSide;
  const auto n = static_cast<std::size_t>(side);
  const double period = shapePeriod(layer), texelsPerMetre = side / period * stretch.y;
  // The weather map repeats after a whole number of shapes.
  const double texelsPerCell = std::round(weatherPeriodM / period) * side / kSide;
  const Windows east = windowsOf(side, kSide, -0.5, texelsPerCell * stretch.x),
                south = windowsOf(side, kSide, -0.5, texelsPerCell * stretch.z);
  const Windows rows = windowsOf(side, kRows, layer.cloudHeight * texelsPerMetre - 0.5,
                                 layer.thickness / kRows * texelsPerMetre, heightSlackM * texelsPerMetre);
  std::vector<float> slice(kRows * n), slices(n * kRows * kSide), cells(std::size_t{kSide} * kRows * kSide);
  for (std::size_t z = 0; z < n; ++z) {
    maximaAcross(rows, &noise.base[z * n * n], n, slice.data());
    maximaAlong(east, slice.data(), kRows, &slices[z * kRows * kSide]);
  }
  maximaAcross(south, slices.data(), std::size_t{kRows} * kSide, cells.data());
  return cells;
}

// Largest value of a square map in each column of cells, at z * kSide + x.
std::vector<float> largestOf(const std::vector<float>& texels, int side) {
  const auto n = static_cast<std::size_t>(side);
  const Windows windows = windowsOf(side, kSide, -0.5, static_cast<double>(side) / kSide);
  std::vector<float> lines(n * kSide), columns(std::size_t{kSide} * kSide);
  maximaAlong(windows, texels.data(), n, lines.data());
  maximaAcross(windows, lines.data(), kSide, columns.data());
  return columns;
}

// The same of a quantity of the weather map.
template <class Quantity>
std::vector<float> largestWeather(const PackedCloudNoise& noise, Quantity quantity) {
  std::vector<float> texels(noise.weather.size());
  std::transform(noise.weather.begin(), noise.weather.end(), texels.begin(), quantity);
  return largestOf(texels, noise.weatherSide);
}

// Largest profile over the heights of each row, by type. At one height the profile is linear in the type
// below stratocumulus and above it, so its maximum over a row is convex there: chords between tabulated types
// lie above it, and over a range of types it is greatest at an end of the range or at stratocumulus.
class ProfileTable {
 public:
  using Rows = std::array<float, kRows>;

  ProfileTable() {
    constexpr int kHeights = 32;      // a row
    constexpr float kSteepest = 10;   // of any profile, per height fraction
    constexpr float kBeyond = 1e-3f;  // rounding of the height
    constexpr float kBetween = kSteepest * (0.5f / (kRows * kHeights) + kBeyond);
    for (int type = 0; type <= kTypes; ++type) {
      for (int row = 0; row < kRows; ++row) {
        float most = 0;
        for (int k = 0; k <= kHeights; ++k) {
          const float height = static_cast<float>(row * kHeights + k) / (kRows * kHeights);
          most = std::max(most, f32::cloudProfile(height, static_cast<float>(type) / kTypes));
        }
        table_[static_cast<std::size_t>(type)][static_cast<std::size_t>(row)] = most + kBetween;
      }
    }
  }

  Rows largest(float lowestType, float highestType) const {
    Rows most;
    most.fill(0);
    raise(most, lowestType);
    raise(most, highestType);
    if (lowestType < 0.5f && highestType > 0.5f) raise(most, 0.5f);
    return most;
  }

 private:
  static constexpr int kTypes = 32;  // even: stratocumulus is one of them

  void raise(Rows& most, float type) const {
    const float at = f32::saturate(type) * kTypes;
    const int below = std::min(static_cast<int>(at), kTypes - 1);
    const float share = at - static_cast<float>(below);
    const Rows& a = table_[static_cast<std::size_t>(below)];
    const Rows& b = table_[static_cast<std::size_t>(below) + 1];
    for (std::size_t row = 0; row < most.size(); ++row) {
      most[row] = std::max(most[row], a[row] + (b[row] - a[row]) * share);
    }
  }

  std::array<Rows, kTypes + 1> table_;
};

// What the form adds, over the heights of each row: its profile and cover at most, its threshold at least.
struct FormRows {
  std::array<float, kRows> profile{}, cover{}, threshold{}, anvil{};

  explicit FormRows(const f32::CloudForm& form) {
    constexpr int kHeights = 64;  // a row, and one beyond each end
    profile.fill(0);
    cover.fill(0);
    threshold.fill(0);
    anvil.fill(0);
    for (std::size_t row = 0; row < kRows; ++row) {
      for (int k = -1; k <= kHeights + 1; ++k) {
        const float height = (static_cast<float>(row) + static_cast<float>(k) / kHeights) / kRows;
        profile[row] = std::max(profile[row], f32::ownProfile(form, height));
        cover[row] = std::max(cover[row], f32::formedCover(form, height));
        anvil[row] = std::max(anvil[row], f32::anvilShare(form, height));
        threshold[row] = std::min(threshold[row], form.anvilThreshold * f32::anvilShare(form, height));
      }
      // Between the heights looked at; the plain form has nothing there.
      constexpr float kBetween = 0.02f;
      profile[row] += kBetween;
      if (form.spread != 1 || form.taper != 0) cover[row] += kBetween * form.spread;
      if (anvil[row] > 0) anvil[row] = std::min(anvil[row] + kBetween, 1.0f);
      if (form.anvilThreshold != 0) threshold[row] += kBetween * form.anvilThreshold;
    }
  }
};

// The cells of a row from west to east, a bit each.
using BitRow = std::array<std::uint64_t, kSide / 64>;

BitRow either(const BitRow& a, const BitRow& b) {
  BitRow both;
  for (std::size_t i = 0; i < both.size(); ++i) both[i] = a[i] | b[i];
  return both;
}

// With both neighbours, around the end.
BitRow widened(const BitRow& row) {
  BitRow wide;
  constexpr std::size_t kLast = kSide / 64 - 1;
  for (std::size_t i = 0; i < row.size(); ++i) {
    wide[i] =
        row[i] | row[i] << 1 | row[i] >> 1 | row[(i + kLast) & kLast] >> 63 | row[(i + 1) & kLast] << 63;
  }
  return wide;
}

// Row r of the slice z is at z * kRows + r.
using BitVolume = std::vector<BitRow>;

std::size_t rowAt(int z, int row) {
  return static_cast<std::size_t>(z & (kSide - 1)) * kRows + static_cast<std::size_t>(row);
}

// Every cell that has an occupied one next to it, corners included.
BitVolume dilated(const BitVolume& volume) {
  BitVolume slices(volume.size()), all(volume.size());
  for (int z = 0; z < kSide; ++z) {
    for (int row = 0; row < kRows; ++row) {
      BitRow grown = volume[rowAt(z, row)];
      if (row > 0) grown = either(grown, volume[rowAt(z, row - 1)]);
      if (row < kRows - 1) grown = either(grown, volume[rowAt(z, row + 1)]);
      slices[rowAt(z, row)] = widened(grown);
    }
  }
  for (int z = 0; z < kSide; ++z) {
    for (int row = 0; row < kRows; ++row) {
      const BitRow sides = either(slices[rowAt(z - 1, row)], slices[rowAt(z + 1, row)]);
      all[rowAt(z, row)] = either(slices[rowAt(z, row)], sides);
    }
  }
  return all;
}

// Counts up the distances of all cells whose bit is not set.
void countMissing(const BitVolume& volume, std::vector<std::uint8_t>& distances) {
  // Eight bits as eight bytes, 1 for a bit that is 0.
  static const auto kMissing = [] {
    std::array<std::array<std::uint8_t, 8>, 256> table{};
    for (std::size_t bits = 0; bits < 256; ++bits) {
      for (std::size_t k = 0; k < 8; ++k) table[bits][k] = (bits >> k & 1) == 0;
    }
    return table;
  }();
  std::uint8_t* at = distances.data();
  for (const BitRow& row : volume) {
    for (const std::uint64_t word : row) {
      for (int shift = 0; shift < 64; shift += 8, at += 8) {
        // No byte overflows, so eight are added at once.
        std::uint64_t sum, missing;
        std::memcpy(&sum, at, 8);
        std::memcpy(&missing, kMissing[word >> shift & 255].data(), 8);
        sum += missing;
        std::memcpy(at, &sum, 8);
      }
    }
  }
}

BitVolume occupiedCells(const PackedCloudNoise& noise, const LayerMedium& of, double weatherPeriodM,
                        double heightSlackM) {
  const CloudLayerSettings& layer = of.layer;
  BitVolume occupied(std::size_t{kSide} * kRows, BitRow{});
  if (!(layer.coverage > 0 && layer.thickness > 0)) return occupied;
  const std::vector<float> base = largestBase(noise, of, weatherPeriodM, heightSlackM);
  const std::vector<float> coverage = largestWeather(noise, [](const glm::vec3& w) { return w.x; });
  // Reach is nowhere less than coverage, so the most of both at a height is that of their largest.
  const bool hasAnvil = of.form.anvilBase < kNoAnvil && !noise.anvils.empty();
  const std::vector<float> reach = hasAnvil ? largestOf(noise.anvils, noise.weatherSide) : coverage;
  const std::vector<float> highestType = largestWeather(noise, [](const glm::vec3& w) { return w.z; });
  const std::vector<float> lowestType = largestWeather(noise, [](const glm::vec3& w) { return -w.z; });
  static const ProfileTable kProfiles;
  const f32::CloudMedium medium{static_cast<float>(layer.densityThreshold),
                                static_cast<float>(layer.coverage), static_cast<float>(layer.typeShift),
                                static_cast<float>(layer.erosion)};
  const f32::CloudForm form{f32::Vec4(of.form.slopes()),
                            static_cast<float>(of.form.own),
                            static_cast<float>(of.form.anvilBase),
                            static_cast<float>(of.form.spread),
                            static_cast<float>(of.form.anvilThreshold),
                            static_cast<float>(of.form.taper),
                            static_cast<float>(of.form.contrast)};
  const FormRows formed(form);
  for (std::size_t column = 0; column < coverage.size(); ++column) {
    const std::size_t x = column % kSide, z = column / kSide;
    const ProfileTable::Rows profile = kProfiles.largest(medium.typeShift - lowestType[column] - kSlack,
                                                         medium.typeShift + highestType[column] + kSlack);
    for (std::size_t row = 0; row < kRows; ++row) {
      const float mostBase = base[(z * kRows + row) * kSide + x] + kSlack;
      f32::CloudMedium there = medium;
      there.coverage *= formed.cover[row];
      there.threshold += formed.threshold[row];
      const float mapped = f32::mix(coverage[column], reach[column], formed.anvil[row]);
      const float covered =
          std::max(f32::formedLocalCoverage(there, form, mapped + kSlack, 0.0f),
                   f32::formedLocalCoverage(there, form, mapped + kSlack, formed.anvil[row]));
      const float most = f32::mix(profile[row], formed.profile[row], form.own);
      const bool isOccupied = f32::profiledDensity(there, mostBase, most, covered) > 0;
      occupied[z * kRows + row][x / 64] |= std::uint64_t{isOccupied} << (x % 64);
    }
  }
  return occupied;
}

}  // namespace

Occupancy::Occupancy(const PackedCloudNoise& noise, const CloudSettings& settings, std::size_t layer)
    : Occupancy(noise, mediumOf(settings, layer)) {}

Occupancy::Occupancy(const PackedCloudNoise& noise, const LayerMedium& medium, double heightSlackM)
    : baseM_(medium.layer.cloudHeight),
      thicknessM_(medium.layer.thickness),
      periodM_(weatherPeriod(medium)),
      distances_(std::size_t{kSide} * kRows * kSide, 0) {
  BitVolume reached = occupiedCells(noise, medium, periodM_, heightSlackM);
  for (const BitRow& row : reached) {
    for (const std::uint64_t word : row) occupied_ += std::popcount(word);
  }
  for (int distance = 0; distance < kFarthest; ++distance) {
    countMissing(reached, distances_);
    if (distance + 1 < kFarthest) reached = dilated(reached);
  }
}

int Occupancy::distance(const glm::ivec3& cell) const {
  assert(cell.y >= 0 && cell.y < kRows);
  return distances_[rowAt(cell.z, cell.y) * kSide + static_cast<std::size_t>(cell.x & (kSide - 1))];
}

glm::ivec3 Occupancy::cellOf(const glm::dvec3& place) const {
  const auto along = [&](double metres) {
    const double periods = metres / periodM_;
    return static_cast<int>((periods - std::floor(periods)) * kSide);
  };
  constexpr double kFarRow = 1e9;  // any place has a row that an int holds
  const double row = std::floor((place.y - baseM_) / thicknessM_ * kRows);
  return {along(place.x), static_cast<int>(std::clamp(row, -kFarRow, kFarRow)), along(place.z)};
}

}  // namespace skydrop::clouds
