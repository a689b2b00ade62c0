// Land from elevation data: a height source like any other.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>

#include "elevation/elevation_source.h"
#include "skydrop/core/error.h"
#include "skydrop/elevation/elevation_height_source.h"
#include "skydrop/elevation/survey.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/terrain/chunk_data.h"
#include "skydrop/terrain/chunk_grid.h"
#include "skydrop/terrain/noise_height_source.h"
#include "support/elevation_files.h"
#include "support/temporary_folder.h"

namespace skydrop::elevation {
namespace {

using terrain::HeightSample;

constexpr GeoPlace kBern{46.9510827861504654, 7.4386324175389165};  // LV95 2600000, 1200000

// Two LV95 tiles of 2 m, 1 km each, side by side, east of Bern's origin.
class TwoTiles : public ::testing::Test {
 protected:
  static double landAt(double east, double north) {
    return 600 + 60 * std::sin(east / 170) * std::cos(north / 230) + 0.05 * north;
  }
  void write(int tile, const test::TiffForm& form = {.tileSide = 64}) {
    const glm::dvec2 corner{2600000 + 1000 * tile, 1201000};
    const auto file = folder_.path() / (std::to_string(tile) + ".tif");
    test::writeGeoTiff(
        file, 500, 500, corner, {2, 2},
        test::heightsOf(
            500, 500, [&](double c, double r) { return landAt(1000 * tile + 2 * c + 1, 1000 - 2 * r - 1); }),
        form);
    rasters_.push_back(openRaster(file));
  }
  using Land = std::shared_ptr<const ElevationHeightSource>;
  // The land of both tiles, and that of one raster with the same cells.
  std::pair<Land, Land> makeCutAndWhole() {
    write(0);
    write(1);
    Land cut = make();
    const auto file = folder_.path() / "both.tif";
    test::writeGeoTiff(
        file, 1000, 500, {2600000, 1201000}, {2, 2},
        test::heightsOf(1000, 500, [&](double c, double r) { return landAt(2 * c + 1, 1000 - 2 * r - 1); }));
    rasters_ = {openRaster(file)};
    return {std::move(cut), make()};
  }
  std::shared_ptr<const ElevationHeightSource> make(double blendM = 2000) {
    return makeElevationHeightSource(rasters_, {false, kBern.latitude, kBern.longitude, blendM},
                                     terrain::makeNoiseHeightSource({}, 1));
  }

  test::TemporaryFolder folder_;
  std::vector<std::shared_ptr<const Raster>> rasters_;
};

TEST_F(TwoTiles, heightsAreThoseOfTheDataAtTheirPlaces) {
  // At the centre of a cell the land has the cell's height; between them that of the smooth land, to
  // centimetres.
  write(0);
  write(1);
  const auto land = make();
  const LocalPlane plane(kBern);
  const Projection lv95("EPSG:2056", "test");
  std::mt19937 random(1);
  for (int i = 0; i < 500; ++i) {
    const int east = 10 + static_cast<int>(random() % 1980), north = 10 + static_cast<int>(random() % 980);
    const glm::dvec2 at = plane.positionOf(*lv95.inverse({2600000 + east, 1200000 + north}));
    EXPECT_NEAR(land->height(at), landAt(east, north), 0.02) << east << " " << north;
  }
}

TEST_F(TwoTiles, gradientIsThatOfTheHeights) {
  // On the data, where they fade, and beyond: analytic and numeric slopes agree.
  write(0);
  write(1);
  const auto land = make();
  std::mt19937 random(2);
  std::uniform_real_distribution<double> x(-3500, 5500), z(-4500, 3500);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec2 at{x(random), z(random)};
    const HeightSample sample = land->sample(at);
    const double h = 0.25;
    const glm::dvec2 numeric{
        (land->height(at + glm::dvec2(h, 0)) - land->height(at - glm::dvec2(h, 0))) / (2 * h),
        (land->height(at + glm::dvec2(0, h)) - land->height(at - glm::dvec2(0, h))) / (2 * h)};
    EXPECT_NEAR(sample.gradient.x, numeric.x, 0.02) << at.x << " " << at.y;
    EXPECT_NEAR(sample.gradient.y, numeric.y, 0.02) << at.x << " " << at.y;
  }
}

TEST_F(TwoTiles, chunksHoldWhatSamplesSay) {
  // Every height of a chunk is the code of sample(), on the data; levels that share a place have one code.
  write(0);
  write(1);
  const auto land = make();
  for (const terrain::ChunkKey key : {terrain::ChunkKey{0, -1, 0}, {0, -1, 3}, {-1, -1, 2}}) {
    const terrain::ChunkData chunk = terrain::makeChunk(*land, key);
    const glm::dvec2 origin = terrain::chunkOrigin(key);
    for (int i = 0; i < terrain::kChunkSamples; i += 8) {
      const glm::dvec2 at = origin + terrain::cellMetres(key.level) * glm::dvec2(i, 240 - i);
      const double stored = chunk.height(static_cast<std::size_t>(terrain::sampleIndex(i, 240 - i)));
      // Where the data fade, the land around comes from its own chunk's codes: half a step of both.
      EXPECT_NEAR(stored, land->height(at), chunk.heightRange.step() / 2 + 0.017) << key.level << " " << i;
    }
  }
  const terrain::ChunkData fine = terrain::makeChunk(*land, {0, -2, 0}),
                           coarse = terrain::makeChunk(*land, {0, -1, 1});
  for (int row = 0; row <= 120; ++row) {
    for (int column = 0; column <= 120; ++column)
      ASSERT_EQ(fine.heights[static_cast<std::size_t>(terrain::sampleIndex(2 * column, 2 * row))],
                coarse.heights[static_cast<std::size_t>(terrain::sampleIndex(column, row))]);
  }
  const terrain::ChunkData east = terrain::makeChunk(*land, {1, -2, 0});
  for (int row = -6; row <= 246; ++row)
    for (int column = -6; column <= 6; ++column)
      ASSERT_EQ(east.normals[static_cast<std::size_t>(terrain::normalIndex(column, row))],
                fine.normals[static_cast<std::size_t>(terrain::normalIndex(240 + column, row))]);
}

TEST_F(TwoTiles, chunksInWhichTheDataFadeMeetTheirNeighbours) {
  // Beyond the data, where both lands count: heights on a border, and normals on both sides of it, are the
  // same bits in neighbouring chunks; heights that two levels share are so too; and they are what sample()
  // says.
  write(0);
  write(1);
  const auto land = make(3000);
  const int side = terrain::kChunkSamples - 1;
  for (const std::int32_t level : {0, 1, 3}) {
    const double size = terrain::chunkMetres(level), cell = terrain::cellMetres(level);
    const int reach = terrain::normalReach(level);
    const auto x = static_cast<std::int32_t>(std::floor(3000 / size));
    const terrain::ChunkData west = terrain::makeChunk(*land, {x, 0, level}),
                             east = terrain::makeChunk(*land, {x + 1, 0, level});
    for (int row = -reach; row <= side + reach; ++row) {
      for (int column = -reach; column <= reach; ++column)
        ASSERT_EQ(west.normals[static_cast<std::size_t>(terrain::normalIndex(side + column, row))],
                  east.normals[static_cast<std::size_t>(terrain::normalIndex(column, row))])
            << level << " " << column << " " << row;
      if (row < 0 || row > side) continue;
      ASSERT_EQ(west.heights[static_cast<std::size_t>(terrain::sampleIndex(side, row))],
                east.heights[static_cast<std::size_t>(terrain::sampleIndex(0, row))]);
    }
    bool isFading = false;
    for (int i = 0; i < side; i += 7) {
      const glm::dvec2 at = terrain::chunkOrigin(east.key) + cell * glm::dvec2(i, side - i);
      const HeightSample truth = land->sample(at);
      isFading = isFading || (!land->hasData(at) && truth.height != 0);
      EXPECT_NEAR(east.height(static_cast<std::size_t>(terrain::sampleIndex(i, side - i))), truth.height,
                  east.heightRange.step() / 2 + 0.017);
      if (level > 0) continue;  // their normals are smoothed
      const glm::dvec3 normal =
          terrain::decodeNormal(east.normals[static_cast<std::size_t>(terrain::normalIndex(i, side - i))]);
      EXPECT_GT(glm::dot(normal, terrain::normalOf(truth)), std::cos(0.025))
          << i;  // two codings of .6 degrees
    }
    EXPECT_TRUE(isFading);
    if (level == 0) continue;
    const terrain::ChunkData fine = terrain::makeChunk(*land, {2 * east.key.x, 0, level - 1});
    for (int row = 0; row <= side / 2; ++row)
      for (int column = 0; column <= side / 2; ++column)
        ASSERT_EQ(fine.heights[static_cast<std::size_t>(terrain::sampleIndex(2 * column, 2 * row))],
                  east.heights[static_cast<std::size_t>(terrain::sampleIndex(column, row))])
            << level << " " << column << " " << row;
  }
}

TEST_F(TwoTiles, everyInstructionSetGivesTheSameChunks) {
  // On the data, where they fade and where a finer mosaic lies in a coarser one.
  write(0);
  const auto coarse = folder_.path() / "coarse.tif";
  test::writeGeoTiff(coarse, 200, 200, {2599500, 1201500}, {10, 10},
                     test::heightsOf(200, 200, [](double c, double r) { return 640 + c / 3 - r / 5; }));
  rasters_.push_back(openRaster(coarse));
  const auto noise = terrain::makeNoiseHeightSource({}, 1);
  const ElevationSettings settings{false, kBern.latitude, kBern.longitude, 2000};
  const auto baseline =
      makeElevationHeightSource(rasters_, settings, noise, *surfaceKernels(core::InstructionSet::baseline));
  int sets = 0;
  for (const core::InstructionSet set : core::kInstructionSets) {
    const SurfaceKernels* kernels = surfaceKernels(set);
    if (kernels == nullptr || set == core::InstructionSet::baseline) continue;
    ++sets;
    const auto land = makeElevationHeightSource(rasters_, settings, noise, *kernels);
    for (const terrain::ChunkKey key :
         {terrain::ChunkKey{0, -1, 0}, {1, -1, 0}, {2, 0, 0}, {-1, -1, 2}, {0, 0, 5}}) {
      const terrain::ChunkData truth = terrain::makeChunk(*baseline, key),
                               chunk = terrain::makeChunk(*land, key);
      EXPECT_EQ(chunk.heights, truth.heights) << static_cast<int>(set) << " " << key.level;
      EXPECT_EQ(chunk.normals, truth.normals) << static_cast<int>(set) << " " << key.level;
    }
  }
  if (sets == 0) GTEST_SKIP() << "no wide instruction set here";
}

TEST_F(TwoTiles, tilesSideBySideFadeAsOneRaster) {
  // However the same cells are cut into tiles, the land beyond them is the same, bit by bit.
  const auto [two, one] = makeCutAndWhole();
  for (double z = -2900; z < 1900; z += 137) {
    for (double x = -1900; x < 3900; x += 61) {
      const HeightSample a = two->sample({x, z}), b = one->sample({x, z});
      ASSERT_NEAR(a.height, b.height, 1e-9) << x << " " << z;
    }
  }
}

TEST_F(TwoTiles, boundsHoldEverySample) {
  write(0);
  write(1);
  const auto land = make();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-4500, 5500), size(1, 3000), share(0, 1);
  for (int i = 0; i < 300; ++i) {
    const glm::dvec2 lo{place(random), place(random)}, hi = lo + glm::dvec2(size(random), size(random));
    const terrain::HeightBounds bounds = land->bounds(lo, hi);
    for (int k = 0; k < 30; ++k) {
      const double height = land->height(lo + glm::dvec2(share(random), share(random)) * (hi - lo));
      ASSERT_GE(height, bounds.lowest);
      ASSERT_LE(height, bounds.highest);
      ASSERT_GE(height, land->range().lowest);
      ASSERT_LE(height, land->range().highest);
    }
  }
  // They are of use: on the data they are those of the data nearby.
  const terrain::HeightBounds small = land->bounds({400, -600}, {440, -560});
  EXPECT_LT(small.highest - small.lowest, 120);
}

TEST_F(TwoTiles, boundsHoldWhatTheSurfaceOvershoots) {
  // Stripes of 0 and 1000 m: between them the surface leaves both by 6 %.
  const auto file = folder_.path() / "stripes.tif";
  test::writeGeoTiff(
      file, 500, 500, {2600000, 1201000}, {2, 2},
      test::heightsOf(500, 500, [](double c, double) { return std::fmod(c, 8) < 4 ? 0.0 : 1000.0; }));
  rasters_ = {openRaster(file)};
  const auto land = make();
  double lowest = 1e9;
  for (double x = 400; x < 440; x += 0.31) {
    const double height = land->height({x, -500});
    const terrain::HeightBounds bounds = land->bounds({x - 1, -501}, {x + 1, -499});
    ASSERT_GE(height, bounds.lowest) << x;
    ASSERT_LE(height, bounds.highest) << x;
    lowest = std::min(lowest, height);
  }
  EXPECT_LT(lowest, -30);
}

TEST_F(TwoTiles, seamBetweenTilesIsExact) {
  // The land of two tiles is the land of one raster that holds both, bit by bit.
  const auto [two, one] = makeCutAndWhole();
  for (double z = -990; z < -10; z += 7.3) {
    for (double x = 980; x < 1020; x += 0.9) {
      const HeightSample a = two->sample({x, z}), b = one->sample({x, z});
      ASSERT_EQ(a.height, b.height) << x << " " << z;
      ASSERT_EQ(a.gradient, b.gradient) << x << " " << z;
    }
  }
}

TEST_F(TwoTiles, turnIntoTheLandAroundWithinTheStatedWidth) {
  write(0);
  const auto noise = terrain::makeNoiseHeightSource({}, 1);
  const auto land = make(2000);
  const double raised = land->facts().raisedM;
  const LocalPlane plane(kBern);
  EXPECT_GT(raised, 0);
  EXPECT_EQ(land->height({5000, -500}), noise->height({5000, -500}) + raised);
  EXPECT_EQ(land->height({1e12, 3}), noise->height({1e12, 3}) + raised);
  EXPECT_NE(land->height({2500, -500}), noise->height({2500, -500}) + raised);
  // No step anywhere along a line from the data outwards.
  double before = land->height({900, -500});
  for (double x = 901; x < 4000; ++x) {
    const double height = land->height({x, -500});
    ASSERT_LT(std::abs(height - before), 3) << x;
    before = height;
  }
  EXPECT_TRUE(std::isfinite(land->height({std::nan(""), 0})));
}

TEST_F(TwoTiles, voidsAreFilledAndCounted) {
  std::vector<float> heights = test::heightsOf(500, 500, [](double c, double) { return 500 + c / 10; });
  for (int row = 100; row < 140; ++row)
    for (int column = 200; column < 260; ++column)
      heights[static_cast<std::size_t>(row * 500 + column)] = -9999;
  const auto file = folder_.path() / "voids.tif";
  test::writeGeoTiff(file, 500, 500, {2600000, 1201000}, {2, 2}, heights,
                     {.tileSide = 64, .nodata = "-9999"});
  rasters_ = {openRaster(file)};
  const auto land = make();
  EXPECT_EQ(land->facts().voids, 40u * 60u);
  for (double x = 380; x < 540; x += 3) EXPECT_NEAR(land->height({x, -760}), 500 + x / 20, 3.2) << x;
}

TEST_F(TwoTiles, aFileThatIsLostWhileFlyingIsFlownOverAndCounted) {
  write(0, {.packing = test::TiffForm::Packing::none});
  const auto land = make();
  std::filesystem::resize_file(folder_.path() / "0.tif", 3000);
  EXPECT_TRUE(std::isfinite(land->height({900, -100})));
  EXPECT_GT(land->faults(), 0u);
}

TEST(LocalPlane, goesThereAndBack) {
  for (const double latitude : {-90.0, -45.0, 0.0, 46.9, 89.9, 90.0}) {
    const LocalPlane plane({latitude, 179.9});
    for (const glm::dvec2 at : {glm::dvec2(0, 0), {1e5, 3e4}, {-3e5, 1e5}, {10, -2e5}}) {
      const glm::dvec2 back = plane.positionOf(plane.placeOf(at));
      EXPECT_NEAR(back.x, at.x, 1e-5) << latitude;
      EXPECT_NEAR(back.y, at.y, 1e-5) << latitude;
    }
  }
}

}  // namespace
}  // namespace skydrop::elevation
