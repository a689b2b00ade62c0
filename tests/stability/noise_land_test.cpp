#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <complex>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include "skydrop/core/error.h"
#include "skydrop/terrain/chunk_data.h"
#include "skydrop/terrain/chunk_grid.h"
#include "support/instrumented.h"
#include "support/margin.h"
#include "terrain/land_gully.h"
#include "terrain/land_octaves.h"
#include "terrain/land_shape.h"
#include "terrain/noise_source.h"

namespace skydrop::terrain {
namespace {

constexpr std::uint64_t kSeed = 20;

// What float arithmetic may move a chunk's sample: 2 mm on heights of 2 km, and 4 mm where a slope of a
// hundredth, known to 1e-6, steers a wave of 150 m.
constexpr double kFloatMetres = 0.006;

std::size_t at(int column, int row) { return static_cast<std::size_t>(sampleIndex(column, row)); }
std::size_t normalAt(int column, int row) { return static_cast<std::size_t>(normalIndex(column, row)); }

glm::dvec2 samplePosition(const ChunkKey& key, int column, int row) {
  return chunkOrigin(key) + glm::dvec2(column, row) * cellMetres(key.level);
}

using Number = Jet<long double>;

// The noise in long double, written from Perlin's definition: the fade-weighted mean of the planes that stand
// on the four nodes.
Number referenceNoise(const Lattice& lattice, long double x, long double z) {
  const long double px = x / lattice.cell + lattice.offsetX, pz = z / lattice.cell + lattice.offsetZ;
  const long double cx = std::floor(px), cz = std::floor(pz);
  const auto i = static_cast<std::int64_t>(cx), j = static_cast<std::int64_t>(cz);
  Number sum;
  for (int dj = 0; dj < 2; ++dj) {
    for (int di = 0; di < 2; ++di) {
      const NodeGradient g = directionOf(nodeBits(lattice.rowSeed(j + dj), i + di));
      const long double u = px - cx - di, w = pz - cz - dj;
      const Number plane{g.x * u + g.z * w, g.x, g.z};
      const Number weightX{1 - fade(std::abs(u)), di == 0 ? -fadeSlope(u) : fadeSlope(-u), 0};
      const Number weightZ{1 - fade(std::abs(w)), 0, dj == 0 ? -fadeSlope(w) : fadeSlope(-w)};
      sum = sum + weightX * weightZ * plane;
    }
  }
  const long double scale = std::sqrt(2.0L);
  return {sum.v * scale, sum.x * scale / lattice.cell, sum.z * scale / lattice.cell};
}

// The land in long double.
class ReferenceLand {
 public:
  ReferenceLand(const TerrainSettings& settings, std::uint64_t seed)
      : shape_(settings), octaves_(makeLandOctaves(settings, seed)) {}

  long double height(glm::dvec2 xz) {
    LandState<Number> state = uncarved(xz.x, xz.y);
    for (std::size_t octave = 0; octave < kGullies.size(); ++octave)
      state.height = state.height + gully(octave, xz.x, xz.y);
    state.detail = sum(octaves_.details, xz.x, xz.y);
    return shape_.finish(state).v;
  }

 private:
  static Number sum(const std::vector<Lattice>& lattices, long double x, long double z) {
    Number total;
    long double share = 1;
    for (const Lattice& lattice : lattices) {
      total = total + referenceNoise(lattice, x, z) * share;
      share /= 2;
    }
    return total;
  }
  LandState<Number> uncarved(long double x, long double z) const {
    LandFields<Number> fields{sum(octaves_.continent, x, z),
                              sum(octaves_.range, x, z),
                              sum(octaves_.crest, x, z),
                              sum(octaves_.valley, x, z),
                              {}};
    for (std::size_t k = 0; k < kHillOctaves; ++k) fields.hills[k] = referenceNoise(octaves_.hills[k], x, z);
    return shape_.begin(fields);
  }
  GullyNode<long double> node(std::size_t octave, std::int64_t i, std::int64_t j) {
    const auto [known, isNew] = nodes_.try_emplace({octave, i, j});
    if (!isNew) return known->second;
    const Lattice& lattice = octaves_.gullies[octave];
    const long double x = (static_cast<long double>(i) - lattice.offsetX) * lattice.cell;
    const long double z = (static_cast<long double>(j) - lattice.offsetZ) * lattice.cell;
    const LandState<Number> land = uncarved(x, z);
    Number slope = land.height;
    for (std::size_t coarser = 0; coarser < octave; ++coarser) slope = slope + gully(coarser, x, z);
    return known->second = gullyNode(nodeBits(lattice.rowSeed(j), i), slope.x, slope.z, land.strength.v);
  }
  Number gully(std::size_t octave, long double x, long double z) {
    const Lattice& lattice = octaves_.gullies[octave];
    const long double px = x / lattice.cell + lattice.offsetX, pz = z / lattice.cell + lattice.offsetZ;
    const long double cx = std::floor(px), cz = std::floor(pz), u = px - cx, w = pz - cz;
    const auto corner = [&](bool east, bool south) {
      return gullyCorner(
          node(octave, static_cast<std::int64_t>(cx) + east, static_cast<std::int64_t>(cz) + south), east,
          south, w);
    };
    const Number blend = gullyBlend(corner(false, false), corner(true, false), corner(false, true),
                                    corner(true, true), FadePlace<long double>{u, fade(u), fadeSlope(u)},
                                    FadePlace<long double>{w, fade(w), fadeSlope(w)});
    const long double metres = kGullies[octave].metres;
    return {blend.v * metres, blend.x * metres / lattice.cell, blend.z * metres / lattice.cell};
  }

  LandShape<long double> shape_;
  LandOctaves octaves_;
  std::map<std::tuple<std::size_t, std::int64_t, std::int64_t>, GullyNode<long double>> nodes_;
};

TEST(Stability, T01_heightsFarOutAreThoseOfALongDoubleReference) {
  // Out to 1e9 m a point is right within 1e-6 m (double keeps positions to 1.2e-7 m there; slopes reach 5)
  // and a chunk's samples are what its format can hold: half a step, and kFloatMetres.
  const TerrainSettings settings;
  ReferenceLand reference(settings, kSeed);
  const auto land = makeNoiseHeightSource(settings, kSeed);
  for (const double distance : {0.0, 1e6, 1e7, 1e9}) {
    const ChunkKey key = chunkAt({distance, -distance});
    const ChunkData chunk = makeChunk(*land, key);
    for (int row = 0; row < kChunkSamples; row += 48) {
      for (int column = 0; column < kChunkSamples; column += 5) {
        const glm::dvec2 xz = samplePosition(key, column, row);
        const auto truth = static_cast<double>(reference.height(xz));
        ASSERT_TRUE(test::holds("T01", test::apart(land->height(xz), truth), test::atMost(1e-6), "m"))
            << distance;
        ASSERT_TRUE(test::holds("T01", test::apart(chunk.height(at(column, row)), truth),
                                test::atMost(chunk.heightRange.step() / 2 + kFloatMetres), "m"))
            << distance;
        const glm::dvec2 between = xz + glm::dvec2(1.37, 2.11);
        ASSERT_TRUE(test::holds(
            "T01", test::apart(land->height(between), static_cast<double>(reference.height(between))),
            test::atMost(1e-6), "m"));
      }
    }
  }
}

TEST(Stability, T01_samplesFarOutAreDistinct) {
  // No terraces: all 241 columns of a chunk differ, on land at every distance.
  test::noFaults("T01", "violations");
  const auto land = makeNoiseHeightSource({}, kSeed);
  for (const double distance : {1e6, 1e7, 1e9, 1e12}) {
    ChunkKey key = chunkAt({distance, -distance});
    while (land->height(samplePosition(key, 120, 120)) < 20) ++key.x;
    const ChunkData chunk = makeChunk(*land, key);
    std::set<std::vector<std::uint16_t>> columns;
    for (int column = 0; column < kChunkSamples; ++column) {
      std::vector<std::uint16_t> heights;
      for (int row = 0; row < kChunkSamples; ++row) heights.push_back(chunk.heights[at(column, row)]);
      columns.insert(heights);
    }
    EXPECT_EQ(columns.size(), std::size_t{kChunkSamples}) << distance;
  }
}

TEST(Stability, T05_theNoiseDoesNotRepeat) {
  // One octave against itself, shifted by 2^k cells along x, z and both: uncorrelated. 60 x 60 cells hold
  // about 3600 independent values, so 0.1 is six standard deviations.
  const Lattice lattice = makeLattice(16, 3, kSeed);
  constexpr double kStep = 16.0 * 60 / 241;
  const auto samples = [&](double x0, double z0) {
    std::vector<double> values;
    for (int row = 0; row < 241; ++row) {
      for (int column = 0; column < 241; ++column)
        values.push_back(noiseAt(lattice, x0 + column * kStep, z0 + row * kStep).v);
    }
    return values;
  };
  const std::vector<double> here = samples(5, 7);
  double power = 0;
  for (const double v : here) power += v * v;
  for (int k = 1; k <= 40; ++k) {
    const double shift = std::ldexp(16.0, k);
    for (const glm::dvec2 by : {glm::dvec2(shift, 0), glm::dvec2(0, shift), glm::dvec2(shift, shift)}) {
      const std::vector<double> there = samples(5 + by.x, 7 + by.y);
      double product = 0, otherPower = 0;
      for (std::size_t i = 0; i < here.size(); ++i) {
        product += here[i] * there[i];
        otherPower += there[i] * there[i];
      }
      ASSERT_TRUE(test::holds("T05", std::abs(product) / std::sqrt(power * otherPower), test::below(0.1),
                              "correlation"))
          << k;
    }
  }
}

TEST(Stability, T06_chunksHoldTheHeightsOfPoints) {
  // What is drawn is what is collided with: at 1000 samples of a chunk, borders included, the stored height
  // is the point's within half a step of the format (16 mm), and kFloatMetres.
  const auto land = makeNoiseHeightSource({}, kSeed);
  core::RandomStream random{6, 0};
  for (const ChunkKey key : {ChunkKey{0, 0, 0}, ChunkKey{-1, -1, 0}, ChunkKey{41, -87, 0}, ChunkKey{-3, 2, 3},
                             ChunkKey{1, 0, 6}, ChunkKey{0, -1, kMaxChunkLevel}}) {
    const ChunkData chunk = makeChunk(*land, key);
    for (int i = 0; i < 1000; ++i) {
      int column = static_cast<int>(random.next() % kChunkSamples);
      int row = static_cast<int>(random.next() % kChunkSamples);
      if (i % 4 == 0) column = i % 8 == 0 ? 0 : kChunkCells;
      if (i % 4 == 1) row = i % 8 == 1 ? 0 : kChunkCells;
      ASSERT_TRUE(test::holds(
          "T06", test::apart(chunk.height(at(column, row)), land->height(samplePosition(key, column, row))),
          test::atMost(chunk.heightRange.step() / 2 + kFloatMetres), "m"))
          << "level " << key.level << " column " << column << " row " << row;
    }
  }
}

TEST(Stability, T07_neighboursShareTheirBorderAndLevelsTheirSamples) {
  // No crack and no pop can come from the data: a position has one code, in whatever chunk and level it lies.
  test::noFaults("T07", "violations");
  const auto land = makeNoiseHeightSource({}, kSeed);
  for (const std::int64_t far : {std::int64_t{0}, std::int64_t{-1}, std::int64_t{1} << 30}) {
    const ChunkData here = makeChunk(*land, {2 * far, 6, 0}), east = makeChunk(*land, {2 * far + 1, 6, 0});
    const ChunkData south = makeChunk(*land, {2 * far, 7, 0});
    for (int i = 0; i < kChunkSamples; ++i) {
      ASSERT_EQ(here.heights[at(kChunkCells, i)], east.heights[at(0, i)]);
      ASSERT_EQ(here.heights[at(i, kChunkCells)], south.heights[at(i, 0)]);
    }
    ChunkKey key{2 * far, 6, 0};
    ChunkData child = here;
    while (key.level < kMaxChunkLevel) {
      const ChunkKey parentKey = parentOf(key);
      const ChunkData parent = makeChunk(*land, parentKey);
      const int column0 = key.x % 2 != 0 ? kChunkCells / 2 : 0, row0 = key.z % 2 != 0 ? kChunkCells / 2 : 0;
      for (int row = 0; row < kChunkSamples; row += 2) {
        for (int column = 0; column < kChunkSamples; column += 2) {
          ASSERT_EQ(child.heights[at(column, row)], parent.heights[at(column0 + column / 2, row0 + row / 2)])
              << "level " << key.level;
        }
      }
      key = parentKey;
      child = parent;
    }
  }
}

TEST(Stability, T07_aPlaceHasOneNormalInAllChunksOfALevelThatReachIt) {
  // Beyond its borders a chunk holds the neighbours' normals, bit by bit: those of the border itself, of the
  // reach on both sides of it, and around the corner. So what is derived from normals within the reach does
  // not depend on the chunk that a place belongs to. All levels, random chunks near the origin and far out.
  test::noFaults("T07", "violations");
  const auto land = makeNoiseHeightSource({}, kSeed);
  core::RandomStream random{70, 0};
  for (int level = 0; level <= kMaxChunkLevel; ++level) {
    for (const std::int64_t far : {std::int64_t{0}, std::int64_t{1} << 30}) {
      const ChunkKey key{far + static_cast<std::int64_t>(random.next() % 200) - 100,
                         static_cast<std::int64_t>(random.next() % 200) - 100, level};
      const ChunkData here = makeChunk(*land, key);
      const int reach = normalReach(level);
      for (const auto& [dx, dz] : {std::pair(1, 0), std::pair(0, 1), std::pair(1, 1), std::pair(-1, 1)}) {
        const ChunkData there = makeChunk(*land, {key.x + dx, key.z + dz, level});
        const int fromX = dx * kChunkCells, fromZ = dz * kChunkCells;
        int compared = 0;
        for (int row = std::max(-reach, fromZ - reach);
             row <= std::min(kChunkCells, fromZ + kChunkCells) + reach; ++row) {
          for (int column = std::max(-reach, fromX - reach);
               column <= std::min(kChunkCells, fromX + kChunkCells) + reach; ++column, ++compared) {
            ASSERT_EQ(here.normals[normalAt(column, row)],
                      there.normals[normalAt(column - fromX, row - fromZ)])
                << "level " << level << " column " << column << " row " << row << " beside " << dx << " "
                << dz;
          }
        }
        EXPECT_EQ(compared,
                  (dx == 0 || dz == 0 ? kChunkSamples + 2 * reach : 2 * reach + 1) * (2 * reach + 1));
      }
    }
  }
}

TEST(Stability, T16_storedNormalsAreThoseOfTheAnalyticGradient) {
  // At 1e4 points of full-detail chunks: on average within half a degree, nowhere beyond two.
  const auto land = makeNoiseHeightSource({}, kSeed);
  core::RandomStream random{16, 0};
  double sum = 0, worst = 0;
  for (int c = 0; c < 20; ++c) {
    const ChunkKey key{static_cast<std::int64_t>(random.next() % 2000) - 1000,
                       static_cast<std::int64_t>(random.next() % 2000) - 1000, 0};
    const ChunkData chunk = makeChunk(*land, key);
    for (int i = 0; i < 500; ++i) {
      const int column = static_cast<int>(random.next() % kChunkSamples);
      const int row = static_cast<int>(random.next() % kChunkSamples);
      const glm::dvec3 stored = decodeNormal(chunk.normals[normalAt(column, row)]);
      const glm::dvec3 truth = normalOf(land->sample(samplePosition(key, column, row)));
      const glm::dvec3 off = stored - truth;
      const double degrees =
          2 * std::asin(0.5 * std::sqrt(off.x * off.x + off.y * off.y + off.z * off.z)) * 57.29578;
      sum += degrees;
      worst = std::max(worst, degrees);
    }
  }
  EXPECT_TRUE(test::holds("T16", sum / 1e4, test::below(0.5), "degrees"));
  EXPECT_TRUE(test::holds("T16", worst, test::below(2.0), "degrees"));
}

TEST(Stability, T16_theAnalyticGradientIsTheSlopeOfTheHeight) {
  // Against central differences of the long double reference over 2 mm: 1e-5 absolute, of slopes up to 5. The
  // rounded creases bend most, by less than 1 / 100 m on the finest octave: 1e-5 a millimetre.
  const TerrainSettings settings;
  ReferenceLand reference(settings, kSeed);
  const auto land = makeNoiseHeightSource(settings, kSeed);
  core::RandomStream random{17, 0};
  int compared = 0;
  for (int i = 0; i < 4000; ++i) {
    const glm::dvec2 xz((random.nextUnit() - 0.5) * 2e5, (random.nextUnit() - 0.5) * 2e5);
    const double h = 0x1p-10;
    const glm::dvec2 gradient = land->sample(xz).gradient;
    const auto difference = [&](glm::dvec2 d) {
      return static_cast<double>(reference.height(xz + d) - reference.height(xz - d)) / (2 * h);
    };
    ASSERT_TRUE(test::holds("T16", test::apart(difference({h, 0}), gradient.x), test::atMost(2e-4), "slope"));
    ASSERT_TRUE(test::holds("T16", test::apart(difference({0, h}), gradient.y), test::atMost(2e-4), "slope"));
    compared += std::abs(gradient.x) > 0.01;
  }
  EXPECT_GT(compared, 2000) << "the land is too flat for this test to mean anything";
}

TEST(Stability, T22_octavesDoNotShareNodes) {
  // Gradient noise is 0 at its nodes: if octaves shared nodes, the land would show a grid. At the nodes of
  // each octave of the hills, the sum of the others varies as it does elsewhere, within 5 %. 40 000 nodes
  // over a million kilometres: the variance itself is known within 0.7 %.
  const LandOctaves octaves = makeLandOctaves({}, kSeed);
  const auto& hills = octaves.hills;
  core::RandomStream random{22, 0};
  for (std::size_t k = 0; k < hills.size(); ++k) {
    double atNodes = 0, elsewhere = 0;
    for (int n = 0; n < 40000; ++n) {
      const double x = (random.nextUnit() - 0.5) * 1e9, z = (random.nextUnit() - 0.5) * 1e9;
      const double cell = hills[k].cell;
      const double nodeX = (std::floor(x / cell) - hills[k].offsetX) * cell;
      const double nodeZ = (std::floor(z / cell) - hills[k].offsetZ) * cell;
      ASSERT_EQ(noiseAt(hills[k], nodeX, nodeZ).v, 0.0);
      double node = 0, other = 0;
      for (std::size_t l = 0; l < hills.size(); ++l) {
        if (l == k) continue;
        const double share = 1.0 / static_cast<double>(1 << l);
        node += share * noiseAt(hills[l], nodeX, nodeZ).v;
        other += share * noiseAt(hills[l], x, z).v;
      }
      atNodes += node * node;
      elsewhere += other * other;
    }
    EXPECT_TRUE(test::holds("T22", test::apart(atNodes / elsewhere, 1.0), test::atMost(0.05), "relative"))
        << "octave " << k;
  }
}

// In-place discrete Fourier transform of 2^n values (Cooley and Tukey, 1965), stride apart.
void transform(std::complex<double>* values, std::size_t count, std::size_t stride) {
  for (std::size_t i = 1, j = 0; i < count; ++i) {
    std::size_t bit = count >> 1;
    for (; j & bit; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i < j) std::swap(values[i * stride], values[j * stride]);
  }
  for (std::size_t length = 2; length <= count; length *= 2) {
    for (std::size_t i = 0; i < count; i += length) {
      for (std::size_t k = 0; k < length / 2; ++k) {
        const auto turn =
            std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(length));
        std::complex<double>& a = values[(i + k) * stride];
        std::complex<double>& b = values[(i + k + length / 2) * stride];
        const std::complex<double> t = b * turn;
        b = a - t;
        a += t;
      }
    }
  }
}

TEST(Stability, T22_theLandFavoursNoDirection) {
  // Spectral power of the land along the axes against along the diagonals (sectors of 22.5 degrees to either
  // side), ring by ring from 4 waves to half the sampling frequency, 60 patches of 128 x 128 samples at full
  // detail and two coarser ones: the mean ratio is under 2, and over 1/2.
  constexpr std::size_t kSize = 128;
  const auto land = makeNoiseHeightSource({}, kSeed);
  core::RandomStream random{23, 0};
  for (const std::int32_t level : {0, 2, 5}) {
    std::vector<double> axis(kSize / 2), diagonal(kSize / 2), axisCount(kSize / 2), diagonalCount(kSize / 2);
    for (int patch = 0; patch < 60;) {
      const ChunkKey key{static_cast<std::int64_t>(random.next() % 2000) - 1000,
                         static_cast<std::int64_t>(random.next() % 2000) - 1000, level};
      const ChunkData chunk = makeChunk(*land, key);
      if (chunk.bounds.highest < 100) continue;
      ++patch;
      std::vector<std::complex<double>> values(kSize * kSize);
      for (std::size_t row = 0; row < kSize; ++row) {
        for (std::size_t column = 0; column < kSize; ++column) {
          const auto window = [](std::size_t i) {
            return 0.5 - 0.5 * std::cos(2 * std::numbers::pi * static_cast<double>(i) / kSize);
          };
          values[row * kSize + column] =
              window(row) * window(column) *
              (chunk.height(at(static_cast<int>(column), static_cast<int>(row))) - chunk.bounds.lowest);
        }
      }
      for (std::size_t i = 0; i < kSize; ++i) transform(&values[i * kSize], kSize, 1);
      for (std::size_t i = 0; i < kSize; ++i) transform(&values[i], kSize, kSize);
      for (std::size_t row = 0; row < kSize; ++row) {
        for (std::size_t column = 0; column < kSize; ++column) {
          const double fx =
              column < kSize / 2 ? static_cast<double>(column) : static_cast<double>(column) - kSize;
          const double fz = row < kSize / 2 ? static_cast<double>(row) : static_cast<double>(row) - kSize;
          const auto ring = static_cast<std::size_t>(std::sqrt(fx * fx + fz * fz));
          if (ring >= kSize / 2) continue;
          const double steep = std::abs(std::abs(fx) - std::abs(fz)) / (std::abs(fx) + std::abs(fz) + 1e-9);
          const bool alongAxis = steep > 0.41421356;  // tan 22.5 degrees, turned by 45
          (alongAxis ? axis : diagonal)[ring] += std::norm(values[row * kSize + column]);
          (alongAxis ? axisCount : diagonalCount)[ring] += 1;
        }
      }
    }
    double logRatio = 0;
    for (std::size_t ring = 4; ring < kSize / 2; ++ring)
      logRatio += std::log(axis[ring] / axisCount[ring] / (diagonal[ring] / diagonalCount[ring]));
    const double ratio = std::exp(logRatio / (kSize / 2 - 4));
    EXPECT_TRUE(test::holds("T22", ratio, test::below(2.0), "times")) << "level " << level;
    EXPECT_GT(ratio, 0.5) << "level " << level;
    RecordProperty("axisToDiagonalAtLevel" + std::to_string(level), std::to_string(ratio));
  }
}

TEST(Stability, T23_heightsLieInTheirRangeAndFewAreLimited) {
  // 1e7 samples: none at the ends of the format's range, and less than 0.1 % of them where the soft limit
  // bends the land (below -200 m or above 1500 m). A third of the world is sea.
  const auto land = makeNoiseHeightSource({}, kSeed);
  core::RandomStream random{23, 0};
  long samples = 0, limited = 0, sea = 0;
  while (samples < 10000000) {
    const ChunkKey key{static_cast<std::int64_t>(random.next() % 20000) - 10000,
                       static_cast<std::int64_t>(random.next() % 20000) - 10000, 5};
    const ChunkData chunk = makeChunk(*land, key);
    for (const std::uint16_t code : chunk.heights) {
      ASSERT_NE(code, 0);
      ASSERT_NE(code, 65535);
      const double height = chunk.heightRange.decode(code);
      limited += height < -200 || height > 1500;
      sea += height < 0;
    }
    samples += static_cast<long>(chunk.heights.size());
  }
  EXPECT_TRUE(test::holds("T23", static_cast<double>(limited),
                          test::below(1e-3 * static_cast<double>(samples)), "samples"));
  EXPECT_GT(static_cast<double>(sea), 0.30 * static_cast<double>(samples));
  EXPECT_LT(static_cast<double>(sea), 0.40 * static_cast<double>(samples));
}

TEST(Stability, T23_heightsStayInRangeForAnySettings) {
  // With every parameter at its ends the soft limit still holds: no sample at the ends of the range.
  test::noFaults("T23", "violations");
  TerrainSettings wild;
  wild.seaDepth = 240;
  wild.plainHeight = 600;
  wild.mountainHeight = 1500;
  wild.rangeShare = 1;
  wild.roughness = wild.plainRoughness = 2;
  for (const double bias : {-1.0, 0.0, 1.0}) {
    wild.landBias = bias;
    const auto land = makeNoiseHeightSource(wild, kSeed);
    for (std::int64_t i = 0; i < 8; ++i) {
      const ChunkData chunk = makeChunk(*land, {i, -i, 5});
      EXPECT_GT(chunk.bounds.lowest, chunk.heightRange.lowest);
      EXPECT_LT(chunk.bounds.highest, chunk.heightRange.highest);
    }
  }
}

// The digest of 64 chunks, made by this many threads.
std::uint64_t worldHash(const HeightSource& land, int workers) {
  std::vector<std::uint64_t> hashes(64);
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < hashes.size(); i = next++) {
      const auto n = static_cast<std::int64_t>(i);
      // Mostly full detail; some coarse, and some far out.
      const ChunkKey key{n % 8 - 4 + (i % 7 == 0 ? std::int64_t{1} << 33 : 0), n / 8 - 4, i % 5 == 0 ? 4 : 0};
      const ChunkData chunk = makeChunk(land, key);
      core::StateHasher hasher;
      // The chunk's own samples; beyond its borders its normals are its neighbours'.
      std::vector<std::uint16_t> normals;
      for (int row = 0; row < kChunkSamples; ++row) {
        for (int column = 0; column < kChunkSamples; ++column)
          normals.push_back(chunk.normals[normalAt(column, row)]);
      }
      for (std::size_t s = 0; s + 1 < chunk.heights.size(); s += 2) {
        const auto pair = [s](const std::vector<std::uint16_t>& v) {
          return std::uint64_t{v[s]} << 16 | v[s + 1];
        };
        hasher.add(pair(chunk.heights) << 32 | pair(normals));
      }
      hasher.add(std::uint64_t{chunk.heights.back()} << 16 | normals.back());
      hashes[i] = hasher.value();
    }
  };
  {
    std::vector<std::jthread> threads;
    for (int w = 0; w < workers; ++w) threads.emplace_back(work);
  }
  core::StateHasher all;
  for (const std::uint64_t hash : hashes) all.add(hash);
  return all.value();
}

TEST(Stability, T24_oneWorldForAnyInstructionSetAndAnyNumberOfWorkers) {
  // The baseline's bits on one thread are the truth; every other set and 2 and 8 workers give the same.
  // (Sets that the processor lacks are left out.) Of one seed under a sanitizer.
  test::noFaults("T24", "differences");
  std::vector<std::uint64_t> seeds = {0, ~std::uint64_t{0}, std::uint64_t{1} << 63};
  if (test::kInstrumented) seeds.resize(1);
  for (const std::uint64_t seed : seeds) {
    const auto baseline = makeNoiseHeightSource({}, seed, *rowKernels(InstructionSet::baseline));
    const std::uint64_t truth = worldHash(*baseline, 1);
    for (const InstructionSet set : kInstructionSets) {
      const RowKernels* kernels = rowKernels(set);
      if (kernels == nullptr || set == InstructionSet::baseline) continue;
      EXPECT_EQ(worldHash(*makeNoiseHeightSource({}, seed, *kernels), 1), truth) << static_cast<int>(set);
    }
    const auto best = makeNoiseHeightSource({}, seed);
    EXPECT_EQ(worldHash(*best, 2), truth);
    EXPECT_EQ(worldHash(*best, 8), truth);
  }
}

TEST(Stability, T24_oneWorldOnEveryMachine) {
  // The digest of seed 1, whatever the processor and the compiler. It changes when the land is changed on
  // purpose, and only then.
  test::noFaults("T24", "differences");
  EXPECT_EQ(worldHash(*makeNoiseHeightSource({}, 1), 2), 4111405345723056612ull);
}

TEST(Stability, T24_seedsGiveDifferentWorlds) {
  // Also those that differ in one bit, or in what a 32-bit or signed seed would lose.
  test::noFaults("T24", "violations");
  std::set<std::uint64_t> hashes;
  for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, ~std::uint64_t{0},
                                   std::uint64_t{1} << 63, std::uint64_t{1} << 32}) {
    hashes.insert(worldHash(*makeNoiseHeightSource({}, seed), 2));
  }
  EXPECT_EQ(hashes.size(), 5u);
}

TEST(Stability, P23_heightsAnswerAnywhere) {
  // Also beyond the world's limit and for what is no position: the nearest position's height, 0 for NaN.
  test::noFaults("P23", "violations");
  const auto land = makeNoiseHeightSource({}, kSeed);
  for (const double x : {1e15, -1e15, 1e18, -1e300, std::numeric_limits<double>::infinity()}) {
    const HeightSample s = land->sample({x, -x});
    EXPECT_GE(s.height, HeightRange{}.lowest);
    EXPECT_LE(s.height, HeightRange{}.highest);
    EXPECT_TRUE(std::isfinite(s.gradient.x) && std::isfinite(s.gradient.y));
  }
  EXPECT_EQ(land->height({1e300, 0}), land->height({kWorldLimitMetres, 0}));
  EXPECT_EQ(land->height({std::nan(""), 0}), land->height({0, 0}));
}

}  // namespace
}  // namespace skydrop::terrain
