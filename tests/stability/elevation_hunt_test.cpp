// The hunt through land of files: any raster (sizes, cells, voids, steps) asked at any place, most often
// where cells, pages and tiles end. SKYDROP_HUNT=1000000 tries as many places (docs/hunt.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "elevation/bicubic.h"
#include "elevation/mosaic.h"
#include "skydrop/elevation/elevation_height_source.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/terrain/chunk_data.h"
#include "skydrop/terrain/noise_height_source.h"
#include "support/hunt.h"
#include "support/hunt_numbers.h"
#include "support/instrumented.h"
#include "support/margin.h"

namespace skydrop::elevation {
namespace {

using test::HuntNumbers;

constexpr float kVoid = std::numeric_limits<float>::quiet_NaN();

std::uint64_t rounds(int usual) {
  return test::huntedInputs(static_cast<std::uint64_t>(test::repetitions(usual)));
}

// Of lands, which take as long as a thousand numbers.
std::uint64_t landRounds(int usual) { return rounds(1000 * usual) / 1000; }

float anyHeight(HuntNumbers& n) {
  if (n.pick(4) == 0) return static_cast<float>(n.pick(2) == 0 ? kLowestHeight : kHighestHeight);
  return static_cast<float>(n.within(kLowestHeight, kHighestHeight));
}

// Heights of which the test knows all.
class HeldHeights final : public Raster {
 public:
  HeldHeights(int width, int height, const Georeference& where, std::vector<float> heights)
      : Raster("held", "test", width, height, where), heights_(std::move(heights)) {}
  void read(int column, int row, int columns, int rows, float* out) const override {
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < columns; ++c) *out++ = at(column + c, row + r);
  }
  float at(int column, int row) const {
    return heights_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width()) +
                    static_cast<std::size_t>(column)];
  }

 private:
  std::vector<float> heights_;
};

// A raster in LV95 around Bern, whose cells are metres.
constexpr glm::dvec2 kBern{2600000, 1200000};
constexpr GeoPlace kBernPlace{46.9510827861504654, 7.4386324175389165};

std::shared_ptr<HeldHeights> anyRaster(HuntNumbers& n, double cell, glm::dvec2 first, int width, int height,
                                       double voids) {
  std::vector<float> heights(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const std::uint64_t kind = n.pick(4);
  const double base = n.within(-400, 4000), across = n.within(-1, 1), down = n.within(-1, 1);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const auto column = static_cast<double>(i % static_cast<std::size_t>(width)),
               row = static_cast<double>(i / static_cast<std::size_t>(width));
    const double smooth = base + cell * (across * column + down * row) * 0.3 +
                          20 * std::sin(column * 0.3) * std::cos(row * 0.2);
    heights[i] = kind == 0   ? anyHeight(n)
                 : kind == 1 ? static_cast<float>(base)
                             : static_cast<float>(std::clamp(smooth, kLowestHeight, kHighestHeight));
    if (i > 0 && n.unit() < voids) heights[i] = kVoid;
  }
  return std::make_shared<HeldHeights>(width, height, Georeference{"EPSG:2056", first, {cell, cell}},
                                       std::move(heights));
}

// One or two tiles of a lattice, and what they are asked through.
struct Land {
  std::vector<std::shared_ptr<const Raster>> tiles;
  std::shared_ptr<HeldHeights> first;  // tiles[0]
  double cell = 1, most = 1;           // m; the largest |height|
  glm::dvec2 middle{};                 // of the first tile, about, in the world
  std::shared_ptr<const ElevationHeightSource> source;
};
Land anyLand(HuntNumbers& n, double voids, std::size_t count, double blendM) {
  static constexpr int kSides[] = {1, 2, 3, 5, 40, 127, 128, 129, 131, 200};
  Land land;
  land.cell = n.pick(3) == 0 ? 2 : n.within(2, 90);
  const int width = kSides[n.pick(10)], height = kSides[n.pick(10)];
  const glm::dvec2 first = kBern + glm::dvec2(n.within(-20000, 20000), n.within(-20000, 20000));
  land.first = anyRaster(n, land.cell, first, width, height, voids);
  land.tiles.push_back(land.first);
  for (std::size_t k = 1; k < count; ++k) {
    // Beside it, over it, or as far away as counts and a page more.
    const double gap = std::floor(n.unit() * (blendM / land.cell + 150));
    const double columns =
        n.pick(2) == 0 ? width + (n.pick(2) == 0 ? gap : 0) : static_cast<double>(n.pick(7)) - 3;
    const double rows = n.pick(4) == 0 ? height + gap : static_cast<double>(n.pick(7)) - 3;
    land.tiles.push_back(anyRaster(n, land.cell, first + land.cell * glm::dvec2(columns, -rows),
                                   kSides[n.pick(10)], kSides[n.pick(10)], voids));
  }
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      if (const float h = land.first->at(column, row); h == h)
        land.most = std::max(land.most, std::abs(static_cast<double>(h)));
  land.middle = {first.x - kBern.x + land.cell * width / 2, kBern.y - first.y + land.cell * height / 2};
  land.source = makeElevationHeightSource(
      land.tiles, {false, kBernPlace.latitude, kBernPlace.longitude, blendM},
      n.pick(2) == 0 ? terrain::makeFlatSource(n.within(-100, 100)) : terrain::makeNoiseHeightSource({}, 1));
  return land;
}
// A place on it, at its edges or beyond.
glm::dvec2 anyPlace(HuntNumbers& n, const Land& land, double blendM) {
  const auto along = [&](int cells) {
    const double half = 0.5 * land.cell * cells;
    switch (n.pick(4)) {
      case 0:
        return n.within(-half, half);
      case 1:
        return (n.pick(2) == 0 ? -half : half) + n.within(-2 * land.cell, 2 * land.cell);
      case 2:
        return (n.pick(2) == 0 ? -half : half) + n.within(-1.1 * blendM, 1.1 * blendM);
      default:
        return (n.unit() - 0.5) * land.cell * 300;
    }
  };
  return land.middle + glm::dvec2(along(land.first->width()), along(land.first->height()));
}

// The last place west of a border between pages, at the same height on the map as another; that where there
// is none near.
glm::dvec2 lastBeforePage(const Chart& chart, double cell, glm::dvec2 xz) {
  Chart::Row row(chart, xz.y);
  const Chart::Spot spot = row.at(xz.x);
  const double border = std::round(spot.at.x / Page::kCells) * Page::kCells;
  double low = xz.x + (border - spot.at.x) * cell - cell, high = low + 2 * cell;
  const auto isBefore = [&](double x) {
    const Chart::Spot at = row.at(x);
    return at.isValid && at.at.x < border;
  };
  if (!spot.isValid || !isBefore(low) || isBefore(high)) return xz;
  while (std::nextafter(low, high) < high) {
    const double middle = low + 0.5 * (high - low);
    if (middle == low || middle == high) break;
    (isBefore(middle) ? low : high) = middle;
  }
  return {low, xz.y};
}

TEST(ElevationHunt, bicubicSurfaceInFloatIsThatOfLongDouble) {
  // Any 4 x 4 heights at any place between: height within 1e-6 of the largest of them (1.2 cm of the
  // deepest), slopes within 4e-6; in double 1e-14; and no further beyond the heights than the survey's bounds
  // say.
  HuntNumbers n(40);
  for (std::uint64_t i = 0; i < rounds(100000); ++i) {
    float cells[16];
    const std::uint64_t kind = n.pick(3);
    const float base = anyHeight(n);
    double most = 0, lowest = 1e9, highest = -1e9;
    for (float& cell : cells) {
      cell = kind == 0   ? base
             : kind == 1 ? anyHeight(n)
                         : static_cast<float>(n.finite({kLowestHeight, kHighestHeight}) * 1e-30);
      cell = std::clamp(cell, static_cast<float>(kLowestHeight), static_cast<float>(kHighestHeight));
      most = std::max(most, std::abs(static_cast<double>(cell)));
      lowest = std::min(lowest, static_cast<double>(cell));
      highest = std::max(highest, static_cast<double>(cell));
    }
    const auto across = static_cast<float>(n.within(0, 1)), down = static_cast<float>(n.within(0, 1));
    const Patch<float> actual = surfaceAt(cells, 4, across, down);
    const Patch<double> fine = surfaceAt(cells, 4, static_cast<double>(across), static_cast<double>(down));
    const Patch<long double> truth =
        surfaceAt(cells, 4, static_cast<long double>(across), static_cast<long double>(down));
    const auto off = [](auto a, long double b) { return static_cast<double>(std::abs(a - b)); };
    ASSERT_LE(off(actual.height, truth.height), 1e-6 * most + 1e-36) << across << " " << down << " " << i;
    ASSERT_LE(off(actual.acrossSlope, truth.acrossSlope), 4e-6 * most + 1e-36)
        << across << " " << down << " " << i;
    ASSERT_LE(off(actual.downSlope, truth.downSlope), 4e-6 * most + 1e-36)
        << across << " " << down << " " << i;
    ASSERT_LE(off(fine.height, truth.height), 1e-14 * most + 1e-300) << across << " " << down << " " << i;
    const double over = static_cast<double>(Survey::kOvershoot) * (highest - lowest) + 2e-6 * most + 1e-36;
    ASSERT_TRUE(truth.height >= lowest - over && truth.height <= highest + over) << across << " " << down;
  }
}

TEST(ElevationHunt, bicubicSurfacesMeetInTheSameBits) {
  // At a common corner, and all along a common side, height and slopes of both are equal; a corner is its
  // height.
  HuntNumbers n(41);
  for (std::uint64_t i = 0; i < rounds(100000); ++i) {
    float cells[25];
    for (float& cell : cells) cell = anyHeight(n);
    const auto along = static_cast<float>(n.within(0, 1));
    const auto same = [](const Patch<float>& a, const Patch<float>& b) {
      return a.height == b.height && a.acrossSlope == b.acrossSlope && a.downSlope == b.downSlope;
    };
    ASSERT_TRUE(same(surfaceAt(cells, 5, 1.0f, along), surfaceAt(cells + 1, 5, 0.0f, along)))
        << along << " " << i;
    ASSERT_TRUE(same(surfaceAt(cells, 5, along, 1.0f), surfaceAt(cells + 5, 5, along, 0.0f)))
        << along << " " << i;
    ASSERT_EQ(surfaceAt(cells, 5, 0.0f, 0.0f).height, cells[6]) << i;
  }
}

TEST(ElevationHunt, landInsideATileIsTheSurfaceOfLongDouble) {
  // Without voids, where all 16 heights are the tile's: height within 2e-6 of the largest, and the gradient
  // that of central differences of the long double surface, through the chart.
  HuntNumbers n(42);
  const std::uint64_t lands = landRounds(20);
  std::uint64_t asked = 0;
  for (std::uint64_t i = 0; i < lands; ++i) {
    const Land land = anyLand(n, 0, 1, 100);
    const HeldHeights& raster = *land.first;
    if (raster.width() < 5 || raster.height() < 5) continue;
    const auto mosaics = makeMosaics(LocalPlane(kBernPlace), land.tiles, 100);
    const double reach = land.cell * std::max(raster.width(), raster.height()) + 2000;
    const Chart chart(LocalPlane(kBernPlace), raster.georeference(), 0,
                      {land.middle - reach, land.middle + reach}, "test");
    const auto truthAt = [&](glm::dvec2 xz) -> long double {
      const Chart::Spot spot = Chart::Row(chart, xz.y).at(xz.x);
      const double column = std::floor(spot.at.x), row = std::floor(spot.at.y);
      if (!spot.isValid || column < 1 || row < 1 || column + 3 > raster.width() || row + 3 > raster.height())
        return std::numeric_limits<long double>::quiet_NaN();
      float cells[16];
      for (int k = 0; k < 16; ++k)
        cells[k] = raster.at(static_cast<int>(column) - 1 + k % 4, static_cast<int>(row) - 1 + k / 4);
      return surfaceAt(cells, 4, static_cast<long double>(spot.at.x) - column,
                       static_cast<long double>(spot.at.y) - row)
          .height;
    };
    for (int k = 0; k < 100; ++k) {
      const glm::dvec2 xz = land.middle + glm::dvec2(n.within(-0.5, 0.5) * land.cell * raster.width(),
                                                     n.within(-0.5, 0.5) * land.cell * raster.height());
      const long double truth = truthAt(xz);
      if (std::isnan(truth)) continue;
      ++asked;
      const terrain::HeightSample sample = land.source->sample(xz);
      ASSERT_LE(std::abs(static_cast<double>(sample.height - truth)), 2e-6 * land.most)
          << xz.x << " " << xz.y << " " << i;
      const double step = land.cell / 16384;
      for (const bool south : {false, true}) {
        const glm::dvec2 by = south ? glm::dvec2(0, step) : glm::dvec2(step, 0);
        const long double difference = (truthAt(xz + by) - truthAt(xz - by)) / (2 * step);
        if (std::isnan(difference)) continue;
        // Second derivatives jump by up to 20 heights a squared cell where cells meet.
        ASSERT_NEAR(south ? sample.gradient.y : sample.gradient.x, static_cast<double>(difference),
                    (1e-5 + 20.0 / 16384) * 2 * land.most / land.cell)
            << xz.x << " " << xz.y << " " << i;
      }
    }
  }
  EXPECT_GT(asked, lands);
}

TEST(ElevationHunt, landOfAnyFileIsFiniteBoundedAndContinuous) {
  // With voids, tiles beside, over and far from each other, fading into other land: within range and the
  // bounds of any rectangle that holds the place; to the next double no further than rounding, from page to
  // page too.
  HuntNumbers n(43);
  const std::uint64_t lands = landRounds(20);
  for (std::uint64_t i = 0; i < lands; ++i) {
    static constexpr double kVoids[] = {0, 0.02, 0.5, 0.98};
    const double blendM = n.pick(3) == 0 ? 1 : n.within(1, 3000);
    const Land land = anyLand(n, kVoids[n.pick(4)], 1 + n.pick(3), blendM);
    const double reach = land.cell * 800 + 2 * blendM + 5000;
    const Chart chart(LocalPlane(kBernPlace), land.first->georeference(), 0,
                      {land.middle - reach, land.middle + reach}, "test");
    const terrain::HeightBounds range = land.source->range();
    const double rounding = 2e-6 * std::max(std::abs(range.lowest), std::abs(range.highest));
    for (int k = 0; k < 100; ++k) {
      const glm::dvec2 any = anyPlace(n, land, blendM);
      const glm::dvec2 xz = n.pick(3) == 0 ? lastBeforePage(chart, land.cell, any) : any;
      const terrain::HeightSample sample = land.source->sample(xz);
      ASSERT_TRUE(std::isfinite(sample.height) && std::isfinite(sample.gradient.x) &&
                  std::isfinite(sample.gradient.y))
          << xz.x << " " << xz.y << " " << i;
      ASSERT_TRUE(sample.height >= range.lowest && sample.height <= range.highest) << xz.x << " " << xz.y;
      const glm::dvec2 low = xz - glm::dvec2(std::abs(n.within(0, 300)), std::abs(n.within(0, 300))),
                       high = xz + glm::dvec2(std::abs(n.within(0, 300)), std::abs(n.within(0, 300)));
      const terrain::HeightBounds bounds = land.source->bounds(low, high);
      ASSERT_TRUE(sample.height >= bounds.lowest && sample.height <= bounds.highest)
          << sample.height << " " << bounds.lowest << " " << bounds.highest << " at " << xz.x << " " << xz.y
          << " " << i;
      const double next = std::nextafter(xz.x, 1e300), beside = land.source->height({next, xz.y});
      ASSERT_NEAR(beside, sample.height, rounding + std::abs(sample.gradient.x) * (next - xz.x))
          << xz.x << " " << xz.y << " " << i;
    }
  }
}

TEST(ElevationHunt, weightsOfTilesFadeSmoothly) {
  // In [0, 1], 1 on a tile, 0 beyond the fading; their gradient is that of central differences within 2 % of
  // the steepest there is.
  HuntNumbers n(44);
  const std::uint64_t lands = landRounds(20);
  for (std::uint64_t i = 0; i < lands; ++i) {
    const double blendM = n.within(20, 3000);
    const Land land = anyLand(n, 0.02, 1 + n.pick(3), blendM);
    const auto mosaics = makeMosaics(LocalPlane(kBernPlace), land.tiles, blendM);
    ASSERT_EQ(mosaics.size(), 1u);
    const auto at = [&](glm::dvec2 xz) { return mosaics[0]->at(xz); };
    for (int k = 0; k < 100; ++k) {
      const glm::dvec2 xz = anyPlace(n, land, blendM);
      const Mosaic::Sample sample = at(xz);
      ASSERT_TRUE(sample.weight >= 0 && sample.weight <= 1) << xz.x << " " << xz.y << " " << i;
      const double step = 1e-3 * blendM;
      const glm::dvec2 difference{
          (at(xz + glm::dvec2(step, 0)).weight - at(xz - glm::dvec2(step, 0)).weight) / (2 * step),
          (at(xz + glm::dvec2(0, step)).weight - at(xz - glm::dvec2(0, step)).weight) / (2 * step)};
      ASSERT_LE(glm::length(difference - sample.weightGradient), 0.02 * 1.5 / blendM)
          << xz.x << " " << xz.y << " " << i;
    }
  }
}

}  // namespace
}  // namespace skydrop::elevation
