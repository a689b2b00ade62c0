// Elevation files of each form: what is in them, and what is refused.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <zip.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "skydrop/core/error.h"
#include "skydrop/core/image.h"
#include "skydrop/elevation/projection.h"
#include "skydrop/elevation/raster.h"
#include "support/elevation_files.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace skydrop::elevation {
namespace {

using test::isOneLineAbout;
using test::refusalOf;
using test::TiffForm;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

std::vector<float> all(const Raster& raster) {
  std::vector<float> heights(static_cast<std::size_t>(raster.width()) * raster.height());
  raster.read(0, 0, raster.width(), raster.height(), heights.data());
  return heights;
}

double hills(double column, double row) { return std::round(500 + 40 * std::sin(column / 7) + row); }

TEST(ElevationReader, readsGeoTiffsOfAllForms) {
  // Strips and tiles, each packing and predictor, floats and whole numbers: the same heights as were written.
  const test::TemporaryFolder folder;
  const std::vector<float> heights = test::heightsOf(53, 37, hills);
  int forms = 0;
  for (const auto packing : {TiffForm::Packing::none, TiffForm::Packing::lzw, TiffForm::Packing::deflate}) {
    for (const int predictor : {1, 2, 3}) {
      for (const int tile : {0, 16}) {
        for (const bool isFloat : {true, false}) {
          if ((packing == TiffForm::Packing::none && predictor > 1) || (predictor == 3 && !isFloat)) continue;
          const auto file = folder.path() / (std::to_string(forms++) + ".tif");
          test::writeGeoTiff(
              file, 53, 37, {2600000, 1200000}, {2, 2}, heights,
              {.packing = packing, .predictor = predictor, .tileSide = tile, .isFloat = isFloat});
          const auto raster = openRaster(file);
          EXPECT_EQ(all(*raster), heights) << raster->form();
          EXPECT_EQ(raster->georeference().crs, "EPSG:2056");
          EXPECT_EQ(raster->georeference().first, glm::dvec2(2600001, 1199999)) << "the centre of a cell";
          std::vector<float> part(6);
          raster->read(14, 15, 3, 2, part.data());
          EXPECT_EQ(part[4], heights[16 * 53 + 15]) << raster->form();
        }
      }
    }
  }
  EXPECT_EQ(forms, 4 + 2 * 10) << "forms were left out";
}

TEST(ElevationReader, knowsVoidsByTheTagAndByWhatIsNoHeight) {
  const test::TemporaryFolder folder;
  for (const auto& [value, tag] : {std::pair(-9999.0F, "-9999"),
                                   {-3.4028235e38F, "-3.4028234663852886e+38"},
                                   {-3.4028235e38F, ""},
                                   {kNaN, "nan"},
                                   {kNaN, ""},
                                   {0.0F, "0"},
                                   {612.5F, "612.5"}}) {
    std::vector<float> heights = test::heightsOf(20, 20, hills);
    heights[45] = value;
    const auto file = folder.path() / "voids.tif";
    test::writeGeoTiff(file, 20, 20, {2600000, 1200000}, {2, 2}, heights, {.nodata = tag});
    const std::vector<float> read = all(*openRaster(file));
    EXPECT_TRUE(std::isnan(read[45])) << value << " with the tag " << tag;
    EXPECT_EQ(std::count_if(read.begin(), read.end(), [](float h) { return std::isnan(h); }), 1);
  }
}

TEST(ElevationReader, knowsPointsFromAreas) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "point.tif";
  test::writeGeoTiff(file, 20, 10, {7, 47}, {0.01, 0.01}, test::heightsOf(20, 10, hills),
                     {.epsg = 4326, .isPoint = true});
  EXPECT_EQ(openRaster(file)->georeference().first, glm::dvec2(7, 47));
  test::writeGeoTiff(file, 20, 10, {7, 47}, {0.01, 0.01}, test::heightsOf(20, 10, hills), {.epsg = 4326});
  EXPECT_NEAR(openRaster(file)->georeference().first.x, 7.005, 1e-12);
}

TEST(ElevationReader, averagesCellsOfHalfAMetre) {
  // Cells of 0.5 m become such of 2 m; voids do not count.
  const test::TemporaryFolder folder;
  std::vector<float> heights = test::heightsOf(40, 40, [](double c, double r) { return c + 100 * r; });
  heights[0] = -9999;
  const auto file = folder.path() / "fine.tif";
  test::writeGeoTiff(file, 40, 40, {2600000, 1200000}, {0.5, 0.5}, heights,
                     {.tileSide = 16, .nodata = "-9999"});
  const auto raster = openRaster(file);
  ASSERT_EQ(raster->width(), 10);
  const std::vector<float> read = all(*raster);
  EXPECT_NEAR(read[11], 5.5 + 550, 1e-3);
  EXPECT_NEAR(read[0], (16 * 151.5 - 0) / 15, 1e-3);
  EXPECT_EQ(raster->georeference().first, glm::dvec2(2600001, 1199999));
}

TEST(ElevationReader, readsSrtmAndItsZip) {
  const test::TemporaryFolder folder;
  const std::string bytes = test::srtmBytes(1201, [](int column, int row) {
    return column == 3 && row == 2 ? -32768 : column == 0 && row == 0 ? -430 : 1000 + column - row;
  });
  const auto check = [](const Raster& raster) {
    const std::vector<float> heights = all(raster);
    EXPECT_EQ(heights[0], -430);
    EXPECT_TRUE(std::isnan(heights[2 * 1201 + 3]));
    EXPECT_EQ(heights[1201 * 1201 - 1], 1000);
    EXPECT_EQ(raster.georeference().first, glm::dvec2(-72, -32)) << "the north-western post of S33W072";
  };
  check(*openRaster(folder.write("S33W072.hgt", bytes)));
  const std::string zip = folder.path() / "any.hgt.zip";
  zip_t* archive = zip_open(zip.c_str(), ZIP_CREATE, nullptr);
  ASSERT_NE(archive, nullptr);
  zip_file_add(archive, "S33W072.hgt", zip_source_buffer(archive, bytes.data(), bytes.size(), 0), 0);
  ASSERT_EQ(zip_close(archive), 0);
  check(*openRaster(zip));
  const std::string refusal =
      refusalOf<core::DataError>([&] { openRaster(folder.write("N01E001.hgt", bytes.substr(2))); });
  EXPECT_TRUE(isOneLineAbout(refusal, "N01E001.hgt")) << refusal;
  EXPECT_NE(refusal.find("2884802"), std::string::npos) << refusal;
  EXPECT_TRUE(isOneLineAbout(refusalOf<core::DataError>([&] { openRaster(folder.write("bern.hgt", bytes)); }),
                             "bern.hgt"));
}

TEST(ElevationReader, readsTexts) {
  const test::TemporaryFolder folder;
  const auto ascii = openRaster(folder.write("a.asc",
                                             "ncols 3\nnrows 2\nxllcorner 2600000\nyllcorner "
                                             "1200000\ncellsize 10\nNODATA_value -99\n1 2 3\n4 -99 6\n"));
  EXPECT_EQ(ascii->georeference().first, glm::dvec2(2600005, 1200015));
  EXPECT_EQ(all(*ascii)[5], 6);
  EXPECT_TRUE(std::isnan(all(*ascii)[4]));
  const auto xyz = openRaster(
      folder.write("a.xyz", "X Y Z\n2600001 1200003 7\r\n2600003 1200001 5.5\n2600001 1200001 4\n"));
  EXPECT_EQ(xyz->width(), 2);
  EXPECT_EQ(xyz->georeference().first, glm::dvec2(2600001, 1200003));
  EXPECT_EQ(all(*xyz)[0], 7);
  EXPECT_TRUE(std::isnan(all(*xyz)[1]));
  EXPECT_EQ(all(*xyz)[3], 5.5F);
  // A .prj beside it has the say about the reference system.
  folder.write("b.prj", "EPSG:32632");
  EXPECT_EQ(openRaster(folder.write("b.xyz", "370000 5200000 500\n370030 5200000 510\n"))->georeference().crs,
            "EPSG:32632");
  const std::string refusal =
      refusalOf<core::DataError>([&] { openRaster(folder.write("c.xyz", "370000 5200000 500\n")); });
  EXPECT_NE(refusal.find(".prj"), std::string::npos) << refusal;
}

TEST(ElevationReader, aReferenceSystemThatNamesAFileIsRefusedAndTheFileIsNotOpened) {
  // PROJ opens grids and initialisation files by path, and waits for a pipe that nobody writes to.
  const test::TemporaryFolder folder;
  const std::string pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const std::string grid =
      folder.write("a.asc", "ncols 2\nnrows 2\nxllcorner 7\nyllcorner 46\ncellsize 1\n1 2\n3 4\n");
  for (const std::string& words :
       {"+init=" + pipe + ":1", "init=" + pipe + ":1", "+proj=longlat +ellps=bessel +nadgrids=" + pipe,
        "proj=longlat ellps=bessel nadgrids=@" + pipe, "+proj=longlat +ellps=bessel +GeoidGrids=" + pipe,
        "+proj=pipeline +step +proj=hgridshift +grids=" + pipe, "+proj=affine +file=" + pipe,
        "PROJCS[\"x\",GEOGCS[\"y\",DATUM[\"z\",SPHEROID[\"s\",6378137,298]],PRIMEM[\"Greenwich\",0],"
        "UNIT[\"degree\",0.0174532925199433]],PROJECTION[\"Mercator_1SP\"],UNIT[\"metre\",1],"
        "EXTENSION[\"PROJ4\",\"+init=" +
            pipe + ":1\"]]"}) {
    folder.write("a.prj", words);
    const std::string line = test::refusalOf<core::DataError>([&] {
      const auto raster = openRaster(grid);
      const Projection projection(raster->georeference().crs, raster->name());
    });
    EXPECT_NE(line.find("names a file of PROJ, and none is read"), std::string::npos)
        << words << ": " << line;
  }
  folder.write("a.prj", "+proj=longlat +datum=WGS84");
  EXPECT_EQ(test::refusalOf<core::DataError>([&] { openRaster(grid); }), "");
}

TEST(ElevationReader, readsHeightsInColours) {
  const test::TemporaryFolder folder;
  const auto image = [](bool terrarium) {
    core::Image picture(4, 4);
    for (int y = 0; y < 4; ++y) {
      for (int x = 0; x < 4; ++x) {
        const double height = 540 + x;
        const auto code = static_cast<unsigned>(terrarium ? (height + 32768) * 256 : (height + 10000) * 10);
        std::uint8_t* p = picture.pixel(x, y);
        p[0] = static_cast<std::uint8_t>(code >> 16);
        p[1] = static_cast<std::uint8_t>(code >> 8);
        p[2] = static_cast<std::uint8_t>(code);
        p[3] = 255;
      }
    }
    return picture;
  };
  for (const bool terrarium : {true, false}) {
    const std::string name = terrarium ? "terrarium" : "rgb";
    core::writePng(folder.path() / (name + ".png"), image(terrarium));
    folder.write(name + ".pgw", "10\n0\n0\n-10\n2600005\n1200035\n");
    const auto raster = openRaster(folder.path() / (name + ".png"));
    EXPECT_EQ(all(*raster)[6], 542) << raster->form();
    EXPECT_EQ(raster->georeference().crs, "EPSG:2056");
  }
  std::filesystem::create_directories(folder.path() / "3/4");
  core::writePng(folder.path() / "3/4/2.png", image(true));
  const auto tile = openRaster(folder.path() / "3/4/2.png");
  EXPECT_EQ(tile->georeference().crs, "EPSG:3857");
  EXPECT_NEAR(tile->georeference().first.x, 20037508.34 / 4 / 8, 1) << "half a cell east of Greenwich";
}

TEST(ElevationReader, refusesWhatItCannotReadInOneLine) {
  const test::TemporaryFolder folder;
  const std::vector<float> heights = test::heightsOf(20, 20, hills);
  const auto tiff = [&](const std::string& name, const TiffForm& form) {
    test::writeGeoTiff(folder.path() / name, 20, 20, {2600000, 1200000}, {2, 2}, heights, form);
    return folder.path() / name;
  };
  tiff("nowhere.tif", {.epsg = 0});
  tiff("unknown.tif", {.epsg = 31});
  folder.write("empty.tif", "");
  folder.write("words.asc", "ncols 2\nnrows two\n");
  folder.write("few.asc", "ncols 2\nnrows 2\nxllcorner 7\nyllcorner 46\ncellsize 1\n1 2 3\n");
  folder.write("short.asc", "ncols 20000\nnrows 20000\nxllcorner 7\nyllcorner 46\ncellsize 1\n1 2 3\n");
  folder.write("loose.xyz", "7 46 1\n7.1 46 1\n7.17 46 1\n");
  folder.write("none.zip", "PK\x05\x06" + std::string(18, '\0'));
  folder.write("bytes.dat", std::string(100, '\0'));
  core::writePng(folder.path() / "photo.png", core::Image(4, 4));
  for (const char* name : {"nowhere.tif", "empty.tif", "words.asc", "few.asc", "short.asc", "loose.xyz",
                           "none.zip", "bytes.dat", "photo.png", "missing.tif", "."}) {
    const std::string line = refusalOf<core::DataError>([&] { openRaster(folder.path() / name); });
    EXPECT_TRUE(isOneLineAbout(line, name)) << name << ": " << line;
  }
}

}  // namespace
}  // namespace skydrop::elevation
