// Aerial images: read, placed, and laid out along the world's axes.
#include "skydrop/elevation/aerial_image.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/image.h"
#include "support/aerial_files.h"
#include "support/instrumented.h"
#include "support/mutants.h"
#include "support/paths.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace skydrop::elevation {
namespace {

namespace fs = std::filesystem;
using terrain::GroundPicture;
using Packing = test::AerialForm::Packing;
using terrain::GroundPictureSettings;

constexpr int kSide = 200;  // pixels
constexpr double kCellM = 10;
constexpr glm::dvec2 kCorner{2599000, 1201000};  // LV95: 2 km around its origin

// Red grows to the east, green to the south; transparent west of the 20th column with four bands.
std::array<std::uint8_t, 4> colourAt(int column, int row) {
  return {static_cast<std::uint8_t>(20 + column), static_cast<std::uint8_t>(20 + row), 60,
          static_cast<std::uint8_t>(column < 20 ? 0 : 255)};
}

void write(const fs::path& file, const test::AerialForm& form) {
  test::writeAerialTiff(file, kSide, kCorner, kCellM, colourAt, form);
}

// What the picture shows at a position of the world (x east, z south).
std::array<int, 4> at(const GroundPicture& picture, glm::dvec2 xz) {
  const glm::dvec2 texel = (xz - picture.corner) / picture.texelM;
  const GroundPicture::Level& level = picture.levels[0];
  const auto column = static_cast<int>(texel.x), row = static_cast<int>(texel.y);
  EXPECT_TRUE(column >= 0 && row >= 0 && column < level.width && row < level.height);
  const std::uint8_t* p = level.rgba.data() + 4 * (static_cast<std::size_t>(row) * level.width + column);
  return {p[0], p[1], p[2], p[3]};
}

constexpr GeoPlace kOrigin{46.9510827861504654, 7.4386324175389165};  // of LV95

class AerialImageTest : public ::testing::Test {
 protected:
  GroundPicture pictureOf(const fs::path& file, const GroundPictureSettings& settings = {.edgeM = 1}) {
    return makeGroundPicture({openAerialImage(file)}, kOrigin, settings);
  }
  test::TemporaryFolder folder_;
};

TEST_F(AerialImageTest, everyFormShowsItsColoursWhereTheyLie) {
  // At LV95's origin the world's axes are the map's to a pixel in a kilometre: a place 500 m east and 300 m
  // south is the 150th column and the 130th row.
  const std::array<std::pair<const char*, test::AerialForm>, 6> forms = {
      {{"none.tif", {}},
       {"lzw.tif", {Packing::lzw, 0, 3}},
       {"deflate.tif", {Packing::deflate, 64, 3}},
       {"jpeg.tif", {Packing::jpeg, 64, 3}},
       {"jpegStrips.tif", {Packing::jpeg, 0, 3}},
       {"alpha.tif", {Packing::deflate, 0, 4}}}};
  for (const auto& [name, form] : forms) {
    write(folder_.path() / name, form);
    const auto image = openAerialImage(folder_.path() / name);
    ASSERT_EQ(image->width(), kSide) << name;
    const GroundPicture picture = pictureOf(folder_.path() / name);
    EXPECT_EQ(picture.texelM, kCellM);
    for (const glm::dvec2 place : {glm::dvec2(505, 305), glm::dvec2(-605, -455), glm::dvec2(5, 5)}) {
      const auto seen = at(picture, place);
      const int within = form.packing == Packing::jpeg ? 6 : 2;
      EXPECT_NEAR(seen[0], 20 + 100 + place.x / kCellM, within) << name;
      EXPECT_NEAR(seen[1], 20 + 100 + place.y / kCellM, within) << name;
      EXPECT_NEAR(seen[2], 60, within) << name;
      EXPECT_EQ(seen[3], 255) << name;
    }
    EXPECT_EQ(at(picture, {-905, 5})[3], form.bands == 4 ? 0 : 255) << name << ": what is transparent";
  }
}

TEST_F(AerialImageTest, aPictureIsPlacedByItsWorldFileOrByCorners) {
  core::Image image(kSide, kSide);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const auto colour = colourAt(x, y);
      std::copy_n(colour.begin(), 3, image.pixel(x, y));
      image.pixel(x, y)[3] = 255;
    }
  }
  const fs::path file = folder_.path() / "picture.png";
  core::writePng(file, image);
  const std::string alone = test::refusalOf<core::DataError>([&] { openAerialImage(file); });
  EXPECT_TRUE(test::isOneLineAbout(alone, "picture.png")) << alone;
  const auto stated = makeGroundPicture(
      {openAerialImage(file, ImageCorners{2599000, 1199000, 2601000, 1201000})}, kOrigin, {.edgeM = 1});
  EXPECT_NEAR(at(stated, {505, 305})[0], 170, 2);
  EXPECT_NE(test::refusalOf<core::DataError>([&] { openAerialImage(file, ImageCorners{2, 1, 1, 2}); }), "");
  folder_.write("picture.pgw", "10\n0\n0\n-10\n2599005\n1200995\n");
  EXPECT_EQ(pictureOf(file).levels[0].rgba, stated.levels[0].rgba);
}

TEST_F(AerialImageTest, theBudgetHoldsAndColoursStay) {
  const fs::path file = folder_.path() / "image.tif";
  write(file, {Packing::lzw, 64, 3});
  const GroundPicture small = pictureOf(file, {.edgeM = 1, .megatexels = 1.0 / 256});
  EXPECT_EQ(small.texelM, 40) << "65 x 65 texels are asked for: 32 m, and a whole number of pixels";
  EXPECT_LE(small.levels[0].width * small.levels[0].height, 64 * 64);
  EXPECT_NEAR(at(small, {500, 300})[0], 170, 4);
  EXPECT_NEAR(at(small, {500, 300})[1], 150, 4);
  const GroundPicture whole = pictureOf(file);
  EXPECT_EQ(whole.levels[2].width, whole.levels[0].width / 4);
}

TEST_F(AerialImageTest, itComesInWithinItsEdgesAndIsNeverMoreThanAlone) {
  const fs::path file = folder_.path() / "image.tif";
  write(file, {});
  const GroundPicture picture = pictureOf(file, {.edgeM = 400});
  int before = 0;
  for (int x = -995; x < 0; x += 10) {
    const int share = at(picture, {static_cast<double>(x), 5})[3];
    EXPECT_GE(share, before) << x;
    before = share;
  }
  EXPECT_LT(at(picture, {-985, 5})[3], 10);
  EXPECT_NEAR(at(picture, {-800, 5})[3], 128, 12);
  EXPECT_EQ(at(picture, {-580, 5})[3], 255);
  EXPECT_EQ(at(picture, {picture.corner.x + 1, 5})[3], 0);
}

TEST_F(AerialImageTest, theFirstOfSeveralHasTheSay) {
  write(folder_.path() / "holes.tif", {Packing::none, 0, 4});
  core::Image red(8, 8);
  for (std::size_t i = 0; i < red.rgba.size(); i += 4) red.rgba[i] = red.rgba[i + 3] = 255;
  core::writePng(folder_.path() / "red.png", red);
  const auto holes = openAerialImage(folder_.path() / "holes.tif");
  const auto under =
      openAerialImage(folder_.path() / "red.png", ImageCorners{2599000, 1199000, 2601000, 1201000});
  const GroundPicture both = makeGroundPicture({holes, under}, kOrigin, {.edgeM = 1});
  EXPECT_EQ(at(both, {-905, 5})[0], 255) << "where the first is transparent";
  EXPECT_NEAR(at(both, {505, 5})[0], 170, 2);
}

TEST_F(AerialImageTest, oneFarAwayIsRefused) {
  const fs::path file = folder_.path() / "image.tif";
  write(file, {});
  const std::string refusal = test::refusalOf<core::DataError>([&] {
    makeGroundPicture({openAerialImage(file)}, {-30, 20}, {});
  });
  EXPECT_TRUE(test::isOneLineAbout(refusal, "image.tif")) << refusal;
}

fs::path corpus() { return fs::path(test::sourceDir()) / "tests/corpus/aerial"; }

// Opens it and lays it out, as land would; the refusal, if there is one.
std::string lookAt(const fs::path& file) {
  return test::refusalOf<core::DataError>([&] {
    const auto image = openAerialImage(file);
    const GroundPicture picture = makeGroundPicture({image}, centreOf(*image), {.megatexels = 1.0 / 16});
    ASSERT_LE(picture.levels[0].rgba.size(), std::size_t{4} << 20);
  });
}

TEST(AerialCorpus, goodFilesAreReadAndBadOnesRefusedInOneLine) {
  std::size_t good = 0, bad = 0;
  for (const auto& entry : fs::directory_iterator(corpus())) {
    if (entry.path().extension() == ".pgw") continue;
    const std::string name = entry.path().filename().string();
    const std::string refusal = lookAt(entry.path());
    if (name.starts_with("good")) {
      ++good;
      EXPECT_EQ(refusal, "") << name;
    } else {
      ++bad;
      // A world file is what is wrong with some.
      EXPECT_TRUE(test::isOneLineAbout(refusal, entry.path().stem().string())) << name << ": " << refusal;
    }
  }
  EXPECT_GE(good, 4u);
  EXPECT_GE(bad, 15u);
}

TEST(AerialCorpus, mutantsAreReadOrRefusedInOneLine) {
  const test::TemporaryFolder folder;
  for (const char* name : {"goodStrips.tif", "goodTiles.tif", "goodGrey.tif", "goodPicture.png"}) {
    std::ifstream stream(corpus() / name, std::ios::binary);
    const std::string content{std::istreambuf_iterator<char>(stream), {}};
    ASSERT_FALSE(content.empty()) << name;
    folder.write("goodPicture.pgw", "10\n0\n0\n-10\n2600005\n1200075\n");
    const fs::path file = folder.path() / name;
    std::size_t refused = 0;
    test::forEachMutant(content, test::repetitions(200), [&](const std::string& mutant) {
      test::writePlainly(file, mutant);
      const std::string refusal = lookAt(file);
      refused += !refusal.empty();
      if (!refusal.empty()) {
        EXPECT_TRUE(test::isOneLineAbout(refusal, name)) << refusal;
      }
    });
    EXPECT_GT(refused, 0u) << name << ": truncated, and read";
  }
}

}  // namespace
}  // namespace skydrop::elevation
