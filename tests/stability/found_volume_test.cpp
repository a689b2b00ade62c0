// Cases that the hunt found in light volumes, in land of files and by a million inputs of each function
// (docs/hunt.md): the input, what the former code made of it (of X61 and X64, which were right already, what
// the obvious code does), and what must hold.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/packing.hpp>
#include <glm/trigonometric.hpp>
#include <memory>
#include <utility>
#include <vector>

#include "clouds/light_cell.h"
#include "elevation/bicubic.h"
#include "skydrop/core/shared.h"
#include "skydrop/elevation/elevation_height_source.h"
#include "skydrop/lab/shared.h"
#include "skydrop/sky/night_light.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/terrain/chunk_data.h"
#include "skydrop/terrain/chunk_grid.h"
#include "support/margin.h"

namespace skydrop {
namespace {

using test::apart, test::atMost, test::holds;

// Of a cell: the former share that its mean has of what comes in.
float formerlyKept(float depth) {
  const float left = std::exp(-depth), known = -std::log(std::max(left, 1e-30f));
  return known > 1e-3f ? (1 - left) / known : 1 - known / 2;
}

TEST(Stability, X60_aCellOfDepth300MakesNoLight) {
  // Of a cell: what it takes less what its mean loses, in units of the light that comes in.
  EXPECT_GT(apart(300 * formerlyKept(300), 1), 3);
  const clouds::CellPassage cell = clouds::cellPassage(300);
  EXPECT_TRUE(holds("X60", apart(300 * cell.kept, 1 - cell.left), atMost(1e-6), "of the light"));
}

TEST(Stability, X61_aThinCellKeepsWhatItTakes) {
  constexpr float depth = 0.00100051251f;
  const long double kept = -expm1l(-static_cast<long double>(depth)) / static_cast<long double>(depth);
  const auto off = [&](float actual) { return std::abs(static_cast<double>(actual / kept - 1)); };
  EXPECT_GT(off((1 - std::exp(-depth)) / depth), 2e-5) << "the difference cancels";
  EXPECT_TRUE(holds("X61", off(clouds::cellPassage(depth).kept), atMost(1e-6), "relative"));
}

TEST(Stability, X62_groundUnderAThickCloudGivesNoLightBelowNone) {
  // 1 / pi of the sky, in half precision, is above 1 / pi.
  constexpr float kAll = 1 / glm::pi<float>();
  const float sky = glm::unpackHalf2x16(glm::packHalf2x16({0, kAll})).y;
  EXPECT_LT(kAll - sky, 0);
  const double ground = core::shared::f32::groundOfVolume(sky);
  EXPECT_TRUE(holds("X62", std::max(0.0, -ground), atMost(0), "1/sr below 0"));
}

// A land that is steeper than codes of normals tell.
class Cliff final : public terrain::HeightSource {
 public:
  terrain::HeightSample sample(glm::dvec2) const override { return {100, {300, 0}}; }
  terrain::HeightBounds bounds(glm::dvec2, glm::dvec2) const override { return {100, 100}; }
  terrain::HeightBounds range() const override { return {100, 100}; }
};

constexpr elevation::GeoPlace kBern{46.9510827861504654, 7.4386324175389165};  // 2600000, 1200000

class FlatHeights final : public elevation::Raster {
 public:
  // firstColumn: cells of 20 m further east.
  explicit FlatHeights(int firstColumn = 0, float height = 500)
      : Raster("flat", "test", 50, 50, {"EPSG:2056", {2599500 + 20.0 * firstColumn, 1200500}, {20, 20}}),
        level_(height) {}
  void read(int, int, int columns, int rows, float* out) const override {
    std::fill_n(out, columns * rows, level_);
  }

 private:
  float level_;
};

TEST(Stability, X63_landThatFadesIntoACliffHasNormals) {
  // The code of the cliff's normal is level: its gradient was 1/0 to the east and 0/0 to the south, and the
  // code of their sum undefined. Codes tell slopes up to 253: a share of a slope of 300 is off by up to 5
  // degrees.
  const glm::dvec3 level = terrain::decodeNormal(terrain::encodeNormal({300, 0}));
  EXPECT_EQ(level.y, 0);
  const auto land = elevation::makeElevationHeightSource({std::make_shared<FlatHeights>()},
                                                         {false, kBern.latitude, kBern.longitude, 2000},
                                                         std::make_shared<Cliff>());
  const terrain::ChunkData chunk = terrain::makeChunk(*land, {0, 0, 0});
  ASSERT_FALSE(chunk.empty());
  std::size_t faded = 0;
  for (int row = 0; row < terrain::kChunkSamples; row += 7) {
    for (int column = 0; column < terrain::kChunkSamples; column += 7) {
      const glm::dvec2 place =
          terrain::chunkOrigin({0, 0, 0}) + terrain::cellMetres(0) * glm::dvec2(column, row);
      const glm::dvec3 normal =
          terrain::decodeNormal(chunk.normals[static_cast<std::size_t>(terrain::normalIndex(column, row))]);
      const glm::dvec3 expected = normalOf(land->sample(place));
      faded += std::abs(expected.x) > 0.1 && expected.y > 0.1 ? 1 : 0;
      const double angle = glm::degrees(std::acos(std::clamp(glm::dot(normal, expected), -1.0, 1.0)));
      ASSERT_TRUE(holds("X63", angle, atMost(12), "degrees")) << column << " " << row;
    }
  }
  EXPECT_GT(faded, 10u);
}

TEST(Stability, X65_tilesFarApartMakeNoStepBetweenPages) {
  // Tiles of 500 and 5000 m, 6.3 km apart, fading over 2 km: of a cell between, on the border of two pages,
  // one knew the far tile and the other did not.
  const auto land = elevation::makeElevationHeightSource(
      {std::make_shared<FlatHeights>(), std::make_shared<FlatHeights>(365, 5000.0f)},
      {false, kBern.latitude, kBern.longitude, 2000}, terrain::makeFlatSource(0));
  double before = land->height({0, 30});
  double steepest = 0;
  for (int x = 1; x < 9000; ++x) {
    const double height = land->height({double(x), 30});
    steepest = std::max(steepest, std::abs(height - before));
    before = height;
  }
  EXPECT_TRUE(holds("X65", steepest, atMost(8), "m a metre"));
}

TEST(Stability, X64_aShareOfACellThatRoundsToAllOfItIsTheNextCell) {
  // A hair west of a cell's border the share in float is 1: the height is that of the border, not of a cell
  // further.
  const float cells[16] = {-12000, 9000, -12000, 9000, 9000, -12000, 9000,   -12000,
                           0,      1,    2,      3,    9000, 9000,   -12000, 9000};
  const double share = 1 - 1e-9;
  ASSERT_EQ(static_cast<float>(share), 1);
  const auto truth = elevation::surfaceAt(cells, 4, share, 0.25);
  const auto actual = elevation::surfaceAt(cells, 4, static_cast<float>(share), 0.25f);
  EXPECT_TRUE(holds("X64", apart(actual.height, truth.height), atMost(0.012), "m"));
}

TEST(Stability, X66_aMoonAHairFromNewIsNotDarkerThanDark) {
  // The sum of Lommel and Seeliger: 1 and the rest cancel. Against 2/3 of the square of what is left to half
  // a turn.
  constexpr double phase = -179.9997783230651;
  const double half = 0.5 * glm::radians(-phase), left = 0.5 * glm::pi<double>() - half;
  EXPECT_LT(1 + std::sin(half) * std::tan(half) * std::log(std::tan(0.5 * half)), 0);
  const double share = sky::lommelSeeligerShare(phase);
  EXPECT_GT(share, 0);
  EXPECT_TRUE(holds("X66", std::abs(share / (2.0 / 3 * left * left) - 1), atMost(1e-9), "relative"));
  EXPECT_NEAR(sky::lommelSeeligerShare(180 - 1.1459), sky::lommelSeeligerShare(180 - 1.1460), 2e-8)
      << "series and sum meet";
}

TEST(Stability, X67_aHairBesideTheMiddleOfATorusTubeIsNotAboveIt) {
  // In double 2.5e-15 outside of the middle, in float in it: up was the gradient there, and is across to all
  // near it.
  const core::shared::f32::Vec3 gradient =
      core::shared::f32::torusGradient({1e-7f, 0, 1.99999964f}, 1.99999964f);
  EXPECT_TRUE(holds("X67", apart(gradient.y, 0), atMost(1e-5), ""));
  EXPECT_NEAR(gradient.z, 1, 1e-5);
  EXPECT_EQ(core::shared::f32::torusGradient({0, 0, 0}, 1e-3f).y, 1) << "on the axis up is as good as any";
}

TEST(Stability, X68_aHeightOfNothingBesideARoundedDistanceIsNoDirection) {
  // The place is 9.5e-10 outside of the tube's middle, in float 0; the height of 3e-19 below it was all that
  // was left, and the gradient pointed down.
  const core::shared::f32::Vec3 gradient =
      core::shared::f32::torusGradient({7e-5f, -3e-19f, 2.57978034f}, 2.57978034f);
  EXPECT_TRUE(holds("X68", apart(gradient.y, 0), atMost(1e-5), ""));
  EXPECT_NEAR(gradient.z, 1, 1e-5);
  EXPECT_NEAR(core::shared::f32::torusGradient({0, 1e-5f, 2.5f}, 2.5f).y, 1, 1e-5)
      << "above the middle is up";
}

TEST(Stability, X69_whatANarrowPixelHasOfAWideBandIsNoDifferenceOfItsEnds) {
  // A pixel of 1 mm half a kilometre along a strip of 1500 m: (500.0005 - 499.9995) / .001 was .977 in float.
  EXPECT_TRUE(
      holds("X69", apart(core::shared::f32::stripCover(500, 750, 0.001f), 1), atMost(1e-6), "of a pixel"));
  const float x = 500, around = 0.0005f;
  EXPECT_GT(1 - (std::min(x + around, 750.0f) - std::max(x - around, -750.0f)) / 0.001f, 0.02f)
      << "the former";
  EXPECT_EQ(core::shared::f32::stripCover(750, 750, 0.001f), 0.5f);
  EXPECT_NEAR(core::shared::f32::stripCover(0, 2, 100), 0.04f, 1e-7) << "all of a narrow band";
}

TEST(Stability, X70_whatIsNoNormalFloatHasNoGloss) {
  // The eye is across from the mirrored ray by all but 1.1e-41, which llvmpipe's pow takes for 5.9e-39: its
  // gloss of a shininess of .00124 was .897, that of C++ .890. A normal number has its own.
  namespace f32 = core::shared::f32;
  namespace f64 = core::shared::f64;
  const auto glossOf = [](double along) {
    const auto small = static_cast<float>(along);
    const double inFloat = f32::phongLight({0, 1, 1, 0.00123918266f}, {0, 1, 0}, {-1, small, 0}, {0, 1, 0}).y;
    const double inDouble = f64::phongLight({0, 1, 1, 0.00123918266}, {0, 1, 0}, {-1, along, 0}, {0, 1, 0}).y;
    return std::pair(inFloat, inDouble);
  };
  const auto [inFloat, inDouble] = glossOf(1.1e-41);
  EXPECT_TRUE(holds("X70", std::max(std::abs(inFloat), std::abs(inDouble)), atMost(0), ""));
  EXPECT_NEAR(glossOf(1e-36).first, std::pow(1e-36, 0.00123918266), 1e-6);
  EXPECT_NEAR(glossOf(1e-36).second, std::pow(1e-36, 0.00123918266), 1e-12);
}

}  // namespace
}  // namespace skydrop
