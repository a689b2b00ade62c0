#include "skydrop/clouds/light_volume.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "clouds/light_cell.h"
#include "skydrop/clouds/raised_sun.h"
#include "skydrop/core/shared.h"

namespace skydrop::clouds {
namespace {

namespace f64 = core::shared::f64;

constexpr int kRows = LightVolume::kRows;
constexpr float kPi = glm::pi<float>();

// Of a value a cell, row by row from the base, then z, then x.
using Grid = std::vector<float>;

// Samples of a cell along each axis, each the extinction of an eighth of it.
constexpr int kSamples = 2, kFineRows = kSamples * kRows;

// How a period of a layer, or a square part of it, is cut into cells.
struct Cut {
  int side;             // cells east and south, a power of two
  float wideM, highM;   // of a cell
  glm::ivec2 first{0};  // of the period's cells, x and z

  std::size_t slice() const { return static_cast<std::size_t>(side) * static_cast<std::size_t>(side); }
  std::size_t cells() const { return slice() * kRows; }
  int fineSide() const { return kSamples * side; }
  std::size_t fineSlice() const { return kSamples * kSamples * slice(); }
};

int wrapped(int i, int side) { return i & (side - 1); }

// Directions: along the eight diagonals, alike (the first set of level-symmetric quadrature, Lathrop and
// Carlson 1966). None is level: light that goes along the layer for ever leaves it nowhere but through cloud.
constexpr float kDirectionWeight = 1.0f / 8;
const float kSine = 1 / std::sqrt(3.0f);

// cellPassage() of every cell.
struct Attenuation {
  Grid left, kept;

  explicit Attenuation(std::size_t cells) : left(cells), kept(cells) {}
  void set(std::size_t cell, float depth) {
    const CellPassage passage = cellPassage(depth);
    left[cell] = passage.left;
    kept[cell] = passage.kept;
  }
};

// Extinction, 1/m, in eighths of cells.
Grid fineExtinctionOf(const CloudField& field, const Cut& cut, const std::stop_token& stop) {
  const auto most = static_cast<float>(field.layer().extinction);
  const double wideM = static_cast<double>(cut.wideM) / kSamples,
               highM = static_cast<double>(cut.highM) / kSamples, baseM = field.layer().cloudHeight;
  const std::size_t slice = cut.fineSlice();
  const auto side = static_cast<std::size_t>(cut.fineSide());
  const glm::dvec2 first = glm::dvec2(kSamples * cut.first) + 0.5;
  Grid fine(slice * kFineRows);
  for (int row = 0; row < kFineRows && !stop.stop_requested(); ++row) {
    for (std::size_t i = 0; i < slice; ++i) {
      const glm::dvec3 place((static_cast<double>(i % side) + first.x) * wideM, baseM + (row + 0.5) * highM,
                             (static_cast<double>(i / side) + first.y) * wideM);
      fine[static_cast<std::size_t>(row) * slice + i] = most * field.densityInFloat(place);
    }
  }
  return fine;
}

// Where the eighths of a cell are in the fine grid.
std::array<std::size_t, 8> eighthsOf(const Cut& cut, std::size_t cell) {
  const auto side = static_cast<std::size_t>(cut.side);
  const std::size_t row = cell / cut.slice(), z = cell % cut.slice() / side, x = cell % side;
  std::array<std::size_t, 8> all{};
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = (row * 2 + (i >> 2)) * cut.fineSlice() + (z * 2 + (i >> 1 & 1)) * 2 * side + x * 2 + (i & 1);
  return all;
}

struct Cells {
  explicit Cells(std::size_t count) : extinction(count), through(count) {}
  Grid extinction;  // mean, 1/m
  Attenuation through;
};

// lessened: of the extinction, what counts as scattering evenly. Holes in a cell are left out: the mean of
// exponentials erred by a twentieth more than that of the depths.
Cells cellsOf(const Grid& fine, const Cut& cut, float lessened) {
  Cells cells(cut.cells());
  for (std::size_t cell = 0; cell < cells.extinction.size(); ++cell) {
    float mean = 0;
    for (const std::size_t eighth : eighthsOf(cut, cell)) mean += fine[eighth] / 8;
    cells.extinction[cell] = mean;
    cells.through.set(cell, lessened * mean * cut.highM / kSine);
  }
  return cells;
}

// Optical depths from eighths of cells to the top of the layer, towards the sun, in steps of two thirds of an
// eighth's shortest side.
class SunDepths {
 public:
  SunDepths(const Grid& fine, const Cut& cut, const glm::dvec3& toSun) : fine_(fine), cut_(cut) {
    const glm::dvec3 inEighths = raisedSun(toSun) * double{kSamples} /
                                 glm::dvec3(static_cast<double>(cut.wideM), static_cast<double>(cut.highM),
                                            static_cast<double>(cut.wideM));
    const double stepM =
        0.66 / std::max({std::abs(inEighths.x), std::abs(inEighths.y), std::abs(inEighths.z)});
    step_ = glm::vec3(inEighths * stepM);
    stepM_ = static_cast<float>(stepM);
  }

  float depth(std::size_t eighth) const {
    const int fineSide = cut_.fineSide();
    const auto side = static_cast<std::size_t>(fineSide);
    const std::size_t slice = cut_.fineSlice();
    glm::vec3 at(static_cast<float>(eighth % side) + 0.5f, static_cast<float>(eighth / slice) + 0.5f,
                 static_cast<float>(eighth % slice / side) + 0.5f);
    float sum = 0;
    at += 0.5f * step_;
    while (at.y < static_cast<float>(kFineRows)) {
      const auto x = static_cast<std::size_t>(wrapped(static_cast<int>(std::floor(at.x)), fineSide)),
                 z = static_cast<std::size_t>(wrapped(static_cast<int>(std::floor(at.z)), fineSide));
      sum += fine_[static_cast<std::size_t>(at.y) * slice + z * side + x];
      at += step_;
    }
    return sum * stepM_;
  }

 private:
  const Grid& fine_;
  const Cut& cut_;
  glm::vec3 step_{0};
  float stepM_ = 0;
};

// What the sun sends straight to the cloud in each cell.
Grid sunOf(const Grid& fine, const Cut& cut, const glm::dvec3& toSun) {
  Grid sun(cut.cells(), 0.0f);
  const SunDepths depths(fine, cut, toSun);
  for (std::size_t cell = 0; cell < sun.size(); ++cell) {
    float sum = 0, weight = 0;
    for (const std::size_t eighth : eighthsOf(cut, cell)) {
      if (!(fine[eighth] > 0)) continue;
      sum += fine[eighth] * std::exp(-depths.depth(eighth));
      weight += fine[eighth];
    }
    if (weight > 0) sun[cell] = sum / weight;
  }
  return sun;
}

// The mean radiance of all directions in every cell, for a source a cell and radiance that comes in at the
// top. Row by row, so that what a row needs stays in the processor's cache.
class Sweep {
 public:
  Sweep(const Cells& cells, const Cut& cut)
      : cells_(cells), side_(cut.side), slice_(cut.slice()), moved_(slice_) {
    for (Grid& in : in_) in.resize(slice_);
    const float shift = std::min(cut.highM / cut.wideM, static_cast<float>(kPad - 2));
    whole_ = static_cast<int>(shift);
    share_ = shift - static_cast<float>(whole_);
  }

  void operator()(const Grid& source, float atTop, Grid& mean) {
    std::ranges::fill(mean, 0.0f);
    for (const bool down : {true, false}) {
      for (Grid& in : in_) std::ranges::fill(in, down ? atTop : 0.0f);
      for (int i = 0; i < kRows; ++i) {
        const std::size_t first = static_cast<std::size_t>(down ? kRows - 1 - i : i) * slice_;
        for (int k = 0; k < 4; ++k) {
          Grid& in = in_[static_cast<std::size_t>(k)];
          if (i > 0) move(in, (k & 1) * 2 - 1, (k & 2) - 1);
          pass(in.data(), source.data(), first, mean.data());
        }
      }
    }
  }

 private:
  static constexpr int kPad = 16;

  // Light through the cells of a row.
  void pass(float* in, const float* sources, std::size_t first, float* means) const {
    const float *left = cells_.through.left.data() + first, *kept = cells_.through.kept.data() + first,
                *source = sources + first;
    float* mean = means + first;
#ifdef __GNUC__
#pragma GCC ivdep
#endif
    for (std::size_t i = 0; i < slice_; ++i) {
      const float over = in[i] - source[i];
      mean[i] += kDirectionWeight * (source[i] + over * kept[i]);
      in[i] = source[i] + over * left[i];
    }
  }

  // From the middle of a row to that of the next light goes as far east or west, and north or south, as rows
  // are high.
  void move(Grid& in, int toX, int toZ) {
    const auto moved = [side = side_](int i, int by) {
      return static_cast<std::size_t>(wrapped(i - by, side)) * static_cast<std::size_t>(side);
    };
    std::array<float, LightVolume::kSide + 2 * kPad> line{};
    float* inner = line.data() + kPad;
    for (int z = 0; z < side_; ++z) {
      const float *near = in.data() + moved(z, toZ * whole_), *far = in.data() + moved(z, toZ * (whole_ + 1));
      for (int x = 0; x < side_; ++x) inner[x] = near[x] + (far[x] - near[x]) * share_;
      for (int i = 0; i < kPad; ++i) {
        inner[side_ + i] = inner[i];
        inner[-1 - i] = inner[side_ - 1 - i];
      }
      const float *nearX = inner - toX * whole_, *farX = inner - toX * (whole_ + 1);
      float* out = moved_.data() + static_cast<std::size_t>(z) * static_cast<std::size_t>(side_);
      for (int x = 0; x < side_; ++x) out[x] = nearX[x] + (farX[x] - nearX[x]) * share_;
    }
    std::swap(in, moved_);
  }

  const Cells& cells_;
  int side_;
  std::size_t slice_;
  int whole_ = 0;
  float share_ = 0;
  std::array<Grid, 4> in_;
  Grid moved_;
};

// Mean radiance in every cell of what has been scattered, or of all where light comes from outside: the fixed
// point of a sweep, with the last two turns mixed so that what they still change is least (Anderson 1965).
// `mean` is where it begins.
Grid solve(Sweep& sweep, const Grid& first, float atTop, Grid mean, const std::stop_token& stop) {
  const std::size_t count = first.size();
  Grid source(count), swept(count), lastSwept, lastChange(count);
  for (int i = 0; i < LightVolume::kIterations && !stop.stop_requested(); ++i) {
    for (std::size_t k = 0; k < count; ++k) source[k] = first[k] + mean[k];
    sweep(source, atTop, swept);
    double product = 0, square = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const float change = swept[k] - mean[k];
      const auto difference = static_cast<double>(change - lastChange[k]);
      product += static_cast<double>(change) * difference;
      square += difference * difference;
      lastChange[k] = change;
    }
    const bool mixes = !lastSwept.empty() && square > 0;
    const auto share = mixes ? static_cast<float>(product / square) : 0.0f;
    if (lastSwept.empty()) lastSwept = swept;
    for (std::size_t k = 0; k < count; ++k)
      mean[k] = std::max(0.0f, swept[k] + share * (lastSwept[k] - swept[k]));
    std::swap(lastSwept, swept);
  }
  return mean;
}

// Light of the sky if every column were an even layer: diffusion between the black ends of Milne's problem.
Grid layeredSky(const Grid& extinction, std::size_t slice, float lessenedM) {
  constexpr float kEnd = 0.7104f;
  Grid mean(extinction.size());
  for (std::size_t column = 0; column < slice; ++column) {
    float all = 0, below = 0;
    for (std::size_t row = 0; row < kRows; ++row) all += lessenedM * extinction[row * slice + column];
    for (std::size_t row = 0; row < kRows; ++row) {
      const float depth = lessenedM * extinction[row * slice + column];
      mean[row * slice + column] = (below + 0.5f * depth + kEnd) / (all + 2 * kEnd) / kPi;
      below += depth;
    }
  }
  return mean;
}

// Coarse cells mix lit cloud with shade and lose light of the sun in the mean: times this it is that of 256
// cells, which the march's share of it was fitted for (the mean of places in cloud, sun at 35 degrees).
float gainOf(int cellsOfAPeriod) {
  switch (cellsOfAPeriod) {
    case 32:
      return 1.235f;
    case 64:
      return 1.131f;
    case 128:
      return 1.055f;
    default:
      return 1;
  }
}

std::vector<LightVolume::Texel> solved(const CloudField& field, const glm::dvec3& toSun, const Cut& cut,
                                       float gain, const std::stop_token& stop) {
  const CloudLayerSettings& layer = field.layer();
  // What scatters onwards by a mean cosine g counts as scattering evenly at (1 - g) of the extinction.
  const double g = std::lerp(layer.anisotropy, f64::kForwardAnisotropy, layer.forwardShare);
  const Grid fine = fineExtinctionOf(field, cut, stop);
  if (stop.stop_requested()) return {};
  const Cells cells = cellsOf(fine, cut, static_cast<float>(1 - g));
  Sweep sweep(cells, cut);
  const Grid none(cut.cells(), 0.0f);
  Grid sun = none;
  if (toSun.y > 0) {
    Grid first = sunOf(fine, cut, toSun);
    for (float& light : first) light /= 4 * kPi;
    sun = solve(sweep, first, 0, none, stop);
  }
  const Grid sky =
      solve(sweep, none, 1 / kPi,
            layeredSky(cells.extinction, cut.slice(), static_cast<float>(1 - g) * cut.highM), stop);
  if (stop.stop_requested()) return {};
  std::vector<LightVolume::Texel> texels(cut.cells());
  const auto wide = static_cast<std::size_t>(cut.side);
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const std::size_t row = i / cut.slice(), z = i % cut.slice() / wide, x = i % wide;
    texels[(z * kRows + row) * wide + x] = {gain * sun[i], std::min(sky[i], 1 / kPi)};
  }
  return texels;
}

Cut cutOf(const CloudField& field, int side, int cells, const glm::ivec2& first) {
  assert(side >= LightVolume::kMinSide && side <= LightVolume::kSide);
  assert(std::has_single_bit(static_cast<unsigned>(side)) &&
         std::has_single_bit(static_cast<unsigned>(cells)));
  return {cells, static_cast<float>(weatherPeriod(field.medium()) / side),
          static_cast<float>(field.layer().thickness / kRows), first};
}

}  // namespace

LightVolume::LightVolume(const CloudField& field, const glm::dvec3& toSun, int side, std::stop_token stop)
    : side_(side),
      baseM_(field.layer().cloudHeight),
      thicknessM_(field.layer().thickness),
      periodM_(weatherPeriod(field.medium())),
      texels_(solved(field, toSun, cutOf(field, side, side, {0, 0}), gainOf(side), stop)),
      isSolved_(!texels_.empty()) {}

std::vector<LightVolume::Texel> LightVolume::part(const CloudField& field, const glm::dvec3& toSun, int side,
                                                  const glm::ivec2& first, int cells, std::stop_token stop) {
  assert(cells >= kMinPart && cells <= side);
  return solved(field, toSun, cutOf(field, side, cells, first), gainOf(side), stop);
}

LightVolume::Texel LightVolume::at(const glm::dvec3& place) const {
  const auto level = [&](double metres) {
    const double turns = metres / periodM_;
    return (turns - std::floor(turns)) * side_ - 0.5;
  };
  const glm::dvec3 cell(level(place.x),
                        std::clamp((place.y - baseM_) / thicknessM_ * kRows - 0.5, 0.0, kRows - 1.0),
                        level(place.z));
  const glm::dvec3 low = glm::floor(cell);
  const glm::vec3 share(cell - low);
  Texel sum;
  for (int corner = 0; corner < 8; ++corner) {
    const int dx = corner & 1, dy = corner >> 1 & 1, dz = corner >> 2;
    const auto x = static_cast<std::size_t>(wrapped(static_cast<int>(low.x) + dx, side_)),
               y = static_cast<std::size_t>(std::min(static_cast<int>(low.y) + dy, kRows - 1)),
               z = static_cast<std::size_t>(wrapped(static_cast<int>(low.z) + dz, side_));
    const float weight =
        (dx ? share.x : 1 - share.x) * (dy ? share.y : 1 - share.y) * (dz ? share.z : 1 - share.z);
    const Texel& texel = texels_[(z * kRows + y) * static_cast<std::size_t>(side_) + x];
    sum.sun += weight * texel.sun;
    sum.sky += weight * texel.sky;
  }
  return sum;
}

}  // namespace skydrop::clouds
