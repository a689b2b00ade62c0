// How far land and ground colours are from what was measured, and what they cost: the tables of
// docs/elevation.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <random>
#include <string>

#include "skydrop/elevation/aerial_image.h"
#include "skydrop/elevation/elevation_height_source.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/terrain/noise_height_source.h"
#include "support/aerial_files.h"
#include "support/elevation_files.h"
#include "support/temporary_folder.h"

namespace skydrop::elevation {
namespace {

constexpr GeoPlace kBern{46.9510827861504654, 7.4386324175389165};  // LV95 2600000, 1200000
constexpr double kSideM = 3600;

struct Error {
  double rms = 0, largest = 0;
  int count = 0;

  void add(double difference) {
    rms += difference * difference;
    largest = std::max(largest, std::abs(difference));
    ++count;
  }
  double root() const { return std::sqrt(rms / count); }
};

// Land with slopes and crests at all sizes from 1 m on, metres east and north of a corner.
double truth(double east, double north) {
  static const auto land = terrain::makeNoiseHeightSource({}, 7);
  return land->height({12000 + east, 8000 - north});
}

double nanosecondsOf(std::clock_t since, int count) {
  return 1e9 * static_cast<double>(std::clock() - since) / CLOCKS_PER_SEC / count;
}

class ElevationError : public ::testing::Test {
 protected:
  test::TemporaryFolder folder_;
};

TEST_F(ElevationError, ofTheBicubicSurfaceIsLessThanOfStraightLinesAtAnyCell) {
  // Heights of the land between its cells against the land that these were taken from; beside it the straight
  // lines of a mesh through the same cells.
  const LocalPlane plane(kBern);
  const Projection lv95("EPSG:2056", "test");
  std::printf("cell m  bicubic rms m  largest  bilinear rms m  largest  ns a height\n");
  double before = 0;
  for (const int cell : {4, 10, 30, 90}) {
    const int side = static_cast<int>(kSideM) / cell;
    const std::vector<float> cells = test::heightsOf(
        side, side, [&](double c, double r) { return truth((c + 0.5) * cell, kSideM - (r + 0.5) * cell); });
    const auto file = folder_.path() / (std::to_string(cell) + ".tif");
    test::writeGeoTiff(file, side, side, {2600000, 1200000 + kSideM}, {cell, cell}, cells);
    const auto land = makeElevationHeightSource(
        {openRaster(file)}, {false, kBern.latitude, kBern.longitude, 2000}, terrain::makeFlatSource(0));
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(400, kSideM - 400);
    Error bicubic, bilinear;
    std::vector<glm::dvec2> places;
    for (int i = 0; i < 4000; ++i) {
      const double east = place(random), north = place(random);
      const double exact = truth(east, north);
      places.push_back(plane.positionOf(*lv95.inverse({2600000 + east, 1200000 + north})));
      bicubic.add(land->height(places.back()) - exact);
      const double x = east / cell - 0.5, y = (kSideM - north) / cell - 0.5;
      const int i0 = static_cast<int>(x), k0 = static_cast<int>(y);
      const auto at = [&](int column, int row) {
        return static_cast<double>(cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(side) +
                                         static_cast<std::size_t>(column)]);
      };
      const double u = x - i0, v = y - k0;
      bilinear.add((1 - v) * ((1 - u) * at(i0, k0) + u * at(i0 + 1, k0)) +
                   v * ((1 - u) * at(i0, k0 + 1) + u * at(i0 + 1, k0 + 1)) - exact);
    }
    const std::clock_t start = std::clock();
    double sum = 0;
    for (const glm::dvec2& at : places) sum += land->height(at);
    const double ns = nanosecondsOf(start, static_cast<int>(places.size()));
    EXPECT_TRUE(std::isfinite(sum));
    std::printf("%6d  %13.3f  %7.2f  %14.3f  %7.2f  %11.0f\n", cell, bicubic.root(), bicubic.largest,
                bilinear.root(), bilinear.largest, ns);
    EXPECT_LT(bicubic.root(), bilinear.root()) << cell;
    EXPECT_GT(bicubic.root(), before) << "coarser cells know less";
    before = bicubic.root();
  }
}

TEST_F(ElevationError, ofAnAerialImageFallsWithTheTexelsThatAreKept) {
  // Fields of 40 m with hedges of 2 m, one pixel: the colour at places of the ground against the image's,
  // of 255.
  const LocalPlane plane(kBern);
  const Projection lv95("EPSG:2056", "test");
  constexpr int kPixels = 1200;
  constexpr double kPixelM = 2;
  const auto colourAt = [](int column, int row) {
    const bool isHedge = column % 20 < 1 || row % 20 < 1;
    const int field = (column / 20 * 7 + row / 20 * 13) % 5;
    return std::array<std::uint8_t, 4>{static_cast<std::uint8_t>(isHedge ? 45 : 110 + 22 * field),
                                       static_cast<std::uint8_t>(isHedge ? 65 : 140 + 12 * field), 70, 255};
  };
  const auto file = folder_.path() / "fields.tif";
  test::writeAerialTiff(file, kPixels, {2600000, 1200000 + kPixels * kPixelM}, kPixelM, colourAt);
  const auto image = openAerialImage(file);
  std::printf("megatexels  texel m  rms of 255  largest     ms\n");
  double before = 1e9;
  for (const double megatexels : {0.0625, 0.25, 1.0, 8.0}) {
    const std::clock_t start = std::clock();
    const terrain::GroundPicture picture =
        makeGroundPicture({image}, kBern, {.edgeM = 1, .megatexels = megatexels});
    const double ms = nanosecondsOf(start, 1) / 1e6;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(20, kPixels * kPixelM - 20);
    Error error;
    for (int i = 0; i < 4000; ++i) {
      const double east = place(random), south = place(random);
      const glm::dvec2 at =
          (plane.positionOf(*lv95.inverse({2600000 + east, 1200000 + kPixels * kPixelM - south})) -
           picture.corner) /
          picture.texelM;
      const terrain::GroundPicture::Level& level = picture.levels[0];
      const std::uint8_t* texel =
          level.rgba.data() + 4 * (static_cast<std::size_t>(at.y) * static_cast<std::size_t>(level.width) +
                                   static_cast<std::size_t>(at.x));
      const auto exact = colourAt(static_cast<int>(east / kPixelM), static_cast<int>(south / kPixelM));
      for (std::size_t c = 0; c < 2; ++c) error.add(double{1} * texel[c] - exact[c]);
    }
    std::printf("%10.4f  %7.0f  %10.1f  %7.0f  %5.0f\n", megatexels, picture.texelM, error.root(),
                error.largest, ms);
    EXPECT_LT(error.root(), before + 0.5) << megatexels;
    before = error.root();
  }
  EXPECT_LT(before, 12) << "half a pixel beside an edge is the other colour, elsewhere it is the image's own";
}

}  // namespace
}  // namespace skydrop::elevation
