// Numerically hard elevation data.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "skydrop/core/error.h"
#include "skydrop/core/image.h"
#include "skydrop/elevation/aerial_image.h"
#include "skydrop/elevation/elevation_height_source.h"
#include "skydrop/elevation/survey.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/terrain/chunk_data.h"
#include "skydrop/terrain/chunk_grid.h"
#include "support/elevation_files.h"
#include "support/margin.h"
#include "support/paths.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace skydrop::elevation {
namespace {

using terrain::HeightSample;
using Rasters = std::vector<std::shared_ptr<const Raster>>;

constexpr double kDegreeM = 111200;  // of latitude, roughly

class ElevationStability : public ::testing::Test {
 protected:
  std::shared_ptr<const Raster> degrees(const std::string& name, int width, int height, glm::dvec2 first,
                                        double cell, const test::HeightOf& heightOf,
                                        test::TiffForm form = {}) {
    form.epsg = 4326;
    form.isPoint = true;
    test::writeGeoTiff(folder_.path() / name, width, height, first, {cell, cell},
                       test::heightsOf(width, height, heightOf), form);
    return openRaster(folder_.path() / name);
  }
  static std::shared_ptr<const ElevationHeightSource> land(const Rasters& rasters, double latitude,
                                                           double longitude, double blendM = 2000) {
    return makeElevationHeightSource(rasters, {false, latitude, longitude, blendM},
                                     terrain::makeFlatSource(0));
  }
  static void expectFinite(const terrain::HeightSource& source, double reachM) {
    for (double z = -reachM; z <= reachM; z += reachM / 16) {
      for (double x = -reachM; x <= reachM; x += reachM / 16) {
        const HeightSample sample = source.sample({x, z});
        ASSERT_TRUE(std::isfinite(sample.height) && std::isfinite(sample.gradient.x) &&
                    std::isfinite(sample.gradient.y))
            << x << " " << z;
        ASSERT_GE(sample.height, source.range().lowest);
        ASSERT_LE(sample.height, source.range().highest);
      }
    }
  }

  test::TemporaryFolder folder_;
};

TEST_F(ElevationStability, D30_theDateLineIsNoEdge) {
  // Two tiles that meet at 180 degrees are the land of one tile that lies elsewhere, seen from either side.
  const auto hills = [](double from) {
    return [from](double c, double r) { return 500 + 100 * std::sin((from + c) / 9) + r; };
  };
  const Rasters across = {degrees("w.tif", 101, 101, {179.9, 10.05}, 0.001, hills(0)),
                          degrees("e.tif", 101, 101, {-180, 10.05}, 0.001, hills(100))};
  const Rasters elsewhere = {degrees("a.tif", 101, 101, {19.9, 10.05}, 0.001, hills(0)),
                             degrees("b.tif", 101, 101, {20, 10.05}, 0.001, hills(100))};
  for (const double east : {-0.02, 0.0, 0.02}) {
    const double longitude = east > 0 ? -180 + east : 180 + east;
    const auto here = land(across, 10, longitude), there = land(elsewhere, 10, 20 + east);
    for (double x = -6000; x <= 6000; x += 37) {
      EXPECT_TRUE(test::holds("D30", test::apart(here->height({x, 300}), there->height({x, 300})),
                              test::atMost(0.01), "m"))
          << x;
      EXPECT_TRUE(here->hasData({x, 300})) << x;
    }
  }
}

TEST_F(ElevationStability, D31_polesAreLand) {
  // A cap of the pole: finite everywhere, one height at the pole itself, right at a degree from it.
  const auto cap = degrees("cap.tif", 361, 21, {-180, 90}, 1, [](double, double r) { return 2800 - 10 * r; });
  for (const double latitude : {90.0, 89.99, 88.0}) {
    const auto source = land({cap}, latitude, 0, 5000);
    expectFinite(*source, 3e5);
  }
  const auto pole = land({cap}, 90, 0, 5000);
  EXPECT_TRUE(test::holds("D31", test::apart(pole->height({0, 0}), 2800), test::atMost(1), "m"));
  for (const glm::dvec2 way : {glm::dvec2(1, 0), {0, 1}, {-1, 0}, {0.6, -0.8}})
    EXPECT_TRUE(
        test::holds("D31", test::apart(pole->height(way * 1.5 * 111694.0), 2785), test::atMost(0.5), "m"));
  const terrain::HeightBounds bounds = pole->bounds({-1e5, -1e5}, {1e5, 1e5});
  EXPECT_LE(bounds.lowest, 2790);
  EXPECT_GE(bounds.highest, 2800);
}

TEST_F(ElevationStability, D32_whatIsNoHeightIsAVoid) {
  // -0.0 is sea level; NaN, both infinities, -3.4e38 and 1e20 are voids, whatever the tag says.
  test::noFaults("D32", "violations");
  for (const char* tag : {"", "-9999", "nan", "-3.4028234663852886e+38"}) {
    const std::vector<float> odd = {-0.0F, NAN, INFINITY, -INFINITY, -3.4028235e38F, 1e20F};
    const auto raster = degrees("odd.tif", 20, 20, {7, 46}, 0.001,
                                [&](double c, double r) {
                                  return r == 3 && c < 6 ? double(odd[static_cast<std::size_t>(c)]) : 400.0;
                                },
                                {.nodata = tag});
    const Survey survey(*raster);
    EXPECT_EQ(survey.voids(), 5u) << tag;
    EXPECT_EQ(survey.all().lowest, 0);
    EXPECT_EQ(survey.all().highest, 400);
    expectFinite(*land({raster}, 46, 7), 5000);
  }
}

TEST_F(ElevationStability, D33_aRasterOfOneCellOrRowOrColumnIsLand) {
  for (const auto& [width, height] : {std::pair(1, 1), {1, 40}, {40, 1}, {2, 2}}) {
    const auto raster =
        degrees("one.tif", width, height, {7, 46}, 0.001, [](double c, double r) { return 700 + c + r; });
    const auto source = land({raster}, 46, 7);
    EXPECT_TRUE(test::holds("D33", test::apart(source->height({0, 0}), 700), test::atMost(0.01), "m"))
        << width << " x " << height;
    expectFinite(*source, 5000);
    EXPECT_FALSE(terrain::makeChunk(*source, {0, 0, 0}).empty());
  }
}

TEST_F(ElevationStability, D34_aRasterOfVoidsAloneIsRefused) {
  test::noFaults("D34", "inputs accepted");
  const auto raster = degrees("void.tif", 30, 20, {7, 46}, 0.001, [](double, double) { return -9999.0; },
                              {.nodata = "-9999"});
  const std::string refusal = test::refusalOf<core::DataError>([&] { land({raster}, 46, 7); });
  EXPECT_TRUE(test::isOneLineAbout(refusal, "void.tif")) << refusal;
  EXPECT_NE(refusal.find("not one cell has a height"), std::string::npos);
}

TEST_F(ElevationStability, D35_halfMetresLieInThirtyMetres) {
  // A tile of 0.5 m within one of 30 m: its heights on it, no step at its edges, whatever the order of files.
  const auto coarse = degrees("coarse.tif", 300, 300, {6.96, 46.04}, 1.0 / 3600,
                              [](double c, double r) { return 500 + c + r; });
  test::writeGeoTiff(folder_.path() / "fine.tif", 400, 400, {0, 0}, {0.5, 0.5},
                     test::heightsOf(400, 400, [](double, double) { return 900.0; }), {.epsg = 32632});
  const LocalPlane plane({46, 7});
  const glm::dvec2 at = *Projection("EPSG:32632", "test").forward({46, 7});
  test::writeGeoTiff(folder_.path() / "fine.tif", 400, 400, {at.x - 100, at.y + 100}, {0.5, 0.5},
                     test::heightsOf(400, 400, [](double, double) { return 900.0; }), {.epsg = 32632});
  const auto fine = openRaster(folder_.path() / "fine.tif");
  EXPECT_TRUE(test::holds("D35", test::apart(fine->georeference().cell.x, 2), test::atMost(1e-9), "m"));
  for (const Rasters& order : {Rasters{fine, coarse}, Rasters{coarse, fine}}) {
    const auto source = land(order, 46, 7);
    EXPECT_TRUE(test::holds("D35", test::apart(source->height({0, 0}), 900), test::atMost(1e-3), "m"));
    double before = source->height({0, 0});
    for (double x = 0; x < 1500; x += 0.5) {
      const double height = source->height({x, 3});
      ASSERT_TRUE(test::holds("D35", std::abs(height - before), test::below(2), "m")) << x;
      before = height;
    }
    EXPECT_TRUE(test::holds(
        "D35", test::apart(before, 500 + (0.04 * 3600 + 1500 / (kDegreeM * std::cos(0.803)) * 3600) + 144),
        test::atMost(3), "m"));
  }
}

TEST_F(ElevationStability, D36_theLowestAndHighestLandAreStored) {
  test::noFaults("D36", "violations");
  const auto raster = degrees("range.tif", 100, 100, {7, 46}, 0.002, [](double c, double r) {
    return c < 50 ? -430.0 : r < 50 ? 8848.0 : 0.0;
  });
  const auto source = land({raster}, 45.9, 7.1);
  EXPECT_LT(source->storedRange().lowest, -430);
  EXPECT_GT(source->storedRange().highest, 8848);
  const terrain::ChunkData chunk = terrain::makeChunk(*source, {-1, -1, 3});
  double lowest = 1e9, highest = -1e9;
  for (std::size_t i = 0; i < chunk.heights.size(); ++i) {
    lowest = std::min(lowest, chunk.height(i));
    highest = std::max(highest, chunk.height(i));
  }
  EXPECT_LT(lowest, -430 + 0.1);
  EXPECT_GT(highest, 8848 - 0.1);
  expectFinite(*source, 15000);
}

TEST_F(ElevationStability, D37_tilesThatShareARowAreOneLandAndTheFirstHasTheSay) {
  const auto north = degrees("n.tif", 50, 50, {7, 46.05}, 0.001, [](double, double) { return 500.0; });
  const auto south = degrees("s.tif", 50, 50, {7, 46.001}, 0.001, [](double, double) { return 510.0; });
  // The shared row lies at 46.001 degrees.
  const glm::dvec2 shared = LocalPlane({46, 7.02}).positionOf({46.001, 7.0205});
  EXPECT_TRUE(test::holds("D37", test::apart(land({north, south}, 46, 7.02)->height(shared), 500),
                          test::atMost(0.01), "m"));
  EXPECT_TRUE(test::holds("D37", test::apart(land({south, north}, 46, 7.02)->height(shared), 510),
                          test::atMost(0.01), "m"));
  const auto source = land({north, south}, 46, 7.02);
  double before = source->height(shared + glm::dvec2(0, 400));
  EXPECT_TRUE(test::holds("D37", test::apart(before, 510), test::atMost(0.01), "m"));
  for (double z = 400; z > -400; z -= 1) {
    const double height = source->height(shared + glm::dvec2(0, z));
    ASSERT_TRUE(test::holds("D37", std::abs(height - before), test::below(0.3), "m")) << z;
    before = height;
  }
}

TEST_F(ElevationStability, D38_truncatedTilesAndWrongCountsAreRefused) {
  test::noFaults("D38", "inputs accepted");
  for (const auto packing :
       {test::TiffForm::Packing::none, test::TiffForm::Packing::lzw, test::TiffForm::Packing::deflate}) {
    for (const int tile : {0, 16}) {
      degrees("whole.tif", 60, 60, {7, 46}, 0.001, [](double c, double r) { return 500 + std::sin(c) + r; },
              {.packing = packing, .tileSide = tile});
      std::ifstream stream(folder_.path() / "whole.tif", std::ios::binary);
      const std::string whole{std::istreambuf_iterator<char>(stream), {}};
      for (std::size_t share = 0; share < 40; ++share) {
        const std::string file = folder_.write("cut.tif", whole.substr(0, whole.size() * share / 40));
        const std::string refusal = test::refusalOf<core::DataError>([&] { Survey(*openRaster(file)); });
        ASSERT_TRUE(test::isOneLineAbout(refusal, "cut.tif")) << share << ": " << refusal;
      }
    }
  }
  for (const char* name : {"badStripCounts.tif", "badStripBytes.tif", "badRowsPerStrip.tif"}) {
    const auto file = std::filesystem::path(test::sourceDir()) / "tests/corpus/elevation" / name;
    const std::string refusal = test::refusalOf<core::DataError>([&] { Survey(*openRaster(file)); });
    EXPECT_TRUE(test::isOneLineAbout(refusal, name)) << name << ": " << refusal;
  }
}

TEST_F(ElevationStability, D39_aHeaderThatLiesAboutItsSizeAllocatesNothing) {
  test::noFaults("D39", "inputs accepted");
  const auto folder = std::filesystem::path(test::sourceDir()) / "tests/corpus/elevation";
  for (const char* name : {"badHuge.tif", "badHuge.asc"}) {
    const std::string refusal = test::refusalOf<core::DataError>([&] { openRaster(folder / name); });
    EXPECT_TRUE(test::isOneLineAbout(refusal, name)) << refusal;
    EXPECT_NE(refusal.find("65536"), std::string::npos) << refusal;
  }
}

TEST_F(ElevationStability, D40_lv95GoesThereAndBack) {
  // Round trips within 2 mm (the system's three-parameter shift is not inverted exactly: 1.2 mm); Bern's old
  // observatory, the origin of the system, within 0.1 m of where swisstopo has it in WGS 84.
  const Projection lv95("EPSG:2056", "test");
  for (double east = 2485000; east <= 2834000; east += 23000) {
    for (double north = 1075000; north <= 1296000; north += 17000) {
      const auto place = lv95.inverse({east, north});
      ASSERT_TRUE(place);
      const auto back = lv95.forward(*place);
      ASSERT_TRUE(back);
      EXPECT_TRUE(test::holds("D40", test::apart(back->x, east), test::atMost(2e-3), "m"));
      EXPECT_TRUE(test::holds("D40", test::apart(back->y, north), test::atMost(2e-3), "m"));
    }
  }
  const auto origin = lv95.forward({46.9510827861504654, 7.4386324175389165});
  ASSERT_TRUE(origin);
  EXPECT_TRUE(test::holds("D40", test::apart(origin->x, 2600000), test::atMost(0.1), "m"));
  EXPECT_TRUE(test::holds("D40", test::apart(origin->y, 1200000), test::atMost(0.1), "m"));
}

TEST_F(ElevationStability, D41_anyPositionHasAHeight) {
  test::noFaults("D41", "violations");
  const auto raster =
      degrees("any.tif", 60, 60, {7, 46}, 0.001, [](double c, double r) { return 500 + c + r; });
  const auto source = land({raster}, 46, 7);
  for (const double x : {0.0, -0.0, 1e-300, 4.9e5, 5.1e5, 1e9, 1e15, 1e300, double(INFINITY),
                         -double(INFINITY), double(NAN)}) {
    for (const double z : {0.0, -5.1e5, 1e15, double(NAN)}) {
      const HeightSample sample = source->sample({x, z});
      EXPECT_TRUE(std::isfinite(sample.height)) << x << " " << z;
      EXPECT_TRUE(std::isfinite(sample.gradient.x) && std::isfinite(sample.gradient.y)) << x << " " << z;
    }
  }
  EXPECT_FALSE(terrain::makeChunk(*source, terrain::chunkAt({1e12, -1e12}, 6)).empty());
}

TEST_F(ElevationStability, D42_anAerialImageOfOnePixelAcrossTheDateLineAndByAPole) {
  // The picture holds the image's colour in the middle, its shares rise from 0 at its rim, its size is
  // bounded.
  test::noFaults("D42", "faults of a picture");
  const test::TemporaryFolder folder;
  const auto write = [&](int width, int height) {
    core::Image image(width, height);
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) image.rgba[i] = image.rgba[i + 3] = 255;
    core::writePng(folder.path() / "image.png", image);
    return folder.path() / "image.png";
  };
  struct Where {
    int width, height;
    ImageCorners corners;
    GeoPlace origin;
  };
  for (const Where& where :
       {Where{1, 1, {7.4, 46.9, 7.5, 47.0}, {46.95, 7.45}},
        Where{1, 200, {7.4, 46.9, 7.4005, 47.0}, {46.95, 7.40025}},
        Where{60, 40, {179.7, -17.2, 180.3, -16.8}, {-17, -180}},
        Where{400, 20, {-180, 89, 180, 90}, {90, 0}}, Where{400, 20, {-180, -90, 180, -89}, {-89.9, 20}}}) {
    const auto image = openAerialImage(write(where.width, where.height), where.corners);
    const terrain::GroundPicture picture =
        makeGroundPicture({image}, where.origin, {.edgeM = 100, .megatexels = 0.25});
    const terrain::GroundPicture::Level& level = picture.levels[0];
    EXPECT_LE(level.width, terrain::kMostGroundTexels);
    EXPECT_LE(level.rgba.size(), std::size_t{8} << 20) << where.width;
    const glm::dvec2 texel = -picture.corner / picture.texelM;  // of the origin
    ASSERT_TRUE(texel.x >= 0 && texel.y >= 0 && texel.x < level.width && texel.y < level.height)
        << where.width;
    const std::uint8_t* pixel = level.rgba.data() + 4 * (static_cast<std::size_t>(texel.y) * level.width +
                                                         static_cast<std::size_t>(texel.x));
    EXPECT_EQ(pixel[0], 255) << where.width << " " << where.origin.latitude;
    EXPECT_GT(pixel[3], 0) << where.width << " " << where.origin.latitude;
    for (int x = 0; x < level.width; ++x) ASSERT_EQ(level.rgba[4 * static_cast<std::size_t>(x) + 3], 0);
  }
  EXPECT_NE(test::refusalOf<core::DataError>([&] {
              openAerialImage(write(2, 2), ImageCorners{7, 46, 7, 47});
            }),
            "");
  EXPECT_NE(test::refusalOf<core::DataError>([&] {
              openAerialImage(write(2, 2), ImageCorners{NAN, 46, 8, 47});
            }),
            "");
}

}  // namespace
}  // namespace skydrop::elevation
