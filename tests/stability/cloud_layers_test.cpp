// The media of the weather's layers: W28, W29; what a genus covers, and what it leaves of the light.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "skydrop/clouds/occupancy.h"
#include "skydrop/core/hash.h"
#include "skydrop/core/shared_clouds.h"
#include "skydrop/game/flown_clouds.h"
#include "support/cloud_noise.h"
#include "support/margin.h"

namespace skydrop {
namespace {

namespace f32 = core::shared::f32;
namespace f64 = core::shared::f64;
using weather::Genus;

struct Usual {
  Genus genus;
  double baseM, topM;
};
// Heights of the International Cloud Atlas (WMO 2017), temperate region.
constexpr std::array<Usual, 7> kUsual{{{Genus::stratus, 400, 900},
                                       {Genus::stratocumulus, 1200, 1900},
                                       {Genus::cumulus, 1555, 3355},
                                       {Genus::altostratus, 3500, 5500},
                                       {Genus::altocumulus, 3500, 4000},
                                       {Genus::nimbostratus, 1000, 5500},
                                       {Genus::cumulonimbus, 1055, 11000}}};

clouds::LayerMedium mediumOf(const Usual& usual, double cover) {
  return game::cloudLayerOf({usual.genus, usual.baseM, usual.topM, cover, 1});
}

TEST(CloudForm, thePlainFormIsTheMediumBitForBit) {
  // In floats and in doubles, at heights in and around a layer, whatever the noise holds.
  const f32::CloudForm plain{f32::Vec4(0.0f, 10.0f, 1.0f, 10.0f), 0, 2, 1, 0, 0, 0};
  core::RandomStream random{5, 0};
  for (int i = 0; i < 20000; ++i) {
    const auto any = [&] { return static_cast<float>(random.nextUnit()); };
    const f32::CloudMedium medium{0.95f * any(), any(), 2 * any() - 1, 0.9f * any()};
    const float height = 1.4f * any() - 0.2f, coverage = any(), type = any(), base = any();
    EXPECT_EQ(f32::formedShapeDensity(medium, plain, height, coverage, type, base),
              f32::cloudShapeDensity(medium, height, {coverage, 0, type, 1}, base));
    EXPECT_EQ(f32::formedShapeEstimate(medium, plain, height, coverage, type, base),
              f32::cloudShapeEstimate(medium, height, coverage, type, base));
  }
}

TEST(Stability, W28_anOccupancyHoldsForAllLayersOfItsRange) {
  // Of each genus: any cover up to that of the occupancy, base and top within its slack. Wherever such a
  // layer has cloud, the cell at that share of its height is occupied.
  test::noFaults("W28", "violations");
  constexpr double kSlackM = 25;
  core::RandomStream random{7, 0};
  for (const Usual& usual : kUsual) {
    const clouds::LayerMedium most = mediumOf(usual, 0.6);
    const clouds::Occupancy occupancy(*test::quickNoise(), most, kSlackM);
    int inCloud = 0;
    for (int layer = 0; layer < 24; ++layer) {
      clouds::LayerMedium medium = most;
      const auto slack = [&] { return kSlackM * (2 * random.nextUnit() - 1); };
      const double base = usual.baseM + slack(), top = usual.topM + slack();
      medium.layer.coverage *= layer % 2 == 0 ? 1 : random.nextUnit();
      medium.layer.cloudHeight = base;
      medium.layer.thickness = top - base;
      const clouds::CloudField field(test::quickNoise(), medium);
      const double period = weatherPeriod(medium);
      for (int i = 0; i < 4000; ++i) {
        const double share = random.nextUnit();
        const glm::dvec3 place(random.nextUnit() * period, base + share * (top - base),
                               random.nextUnit() * period);
        if (!(field.densityInFloat(place) > 0)) continue;
        ++inCloud;
        const int row =
            std::min(static_cast<int>(share * clouds::Occupancy::kRows), clouds::Occupancy::kRows - 1);
        const glm::ivec3 cell = occupancy.cellOf({place.x, usual.baseM, place.z});
        ASSERT_EQ(occupancy.distance({cell.x, row, cell.z}), 0)
            << weather::kGenusNames[static_cast<std::size_t>(usual.genus)];
      }
    }
    EXPECT_GT(inCloud, 100) << weather::kGenusNames[static_cast<std::size_t>(usual.genus)]
                            << " proves little";
  }
}

TEST(Stability, W29_floatsAndDoublesGiveTheDensityOfEachGenus) {
  // What a shader computes from the wrapped place on is that of doubles within 2e-5, at the origin, after a
  // month of drift and 1e9 m out; in [0, 1].
  core::RandomStream random{9, 0};
  for (const Usual& usual : kUsual) {
    clouds::CloudField field(test::quickNoise(), mediumOf(usual, 0.8));
    for (const double far : {0.0, 2.1e7, 1e9}) {
      for (int i = 0; i < 3000; ++i) {
        const glm::dvec3 place(far + random.nextUnit() * 1e5,
                               usual.baseM + random.nextUnit() * (usual.topM - usual.baseM),
                               -far + random.nextUnit() * 1e5);
        const double density = field.density(place);
        EXPECT_TRUE(test::holds("W29", test::apart(static_cast<double>(field.densityInFloat(place)), density),
                                test::atMost(2e-5), "density"));
        EXPECT_GE(density, 0);
        EXPECT_LE(density, 1);
      }
    }
  }
}

// Share of the sun's light on level ground that comes through an even layer of droplets over black ground: by
// photons one by one (Henyey and Greenstein, asymmetry 0.85, nothing absorbed).
double transmittedByPhotons(double depth, double sine) {
  constexpr int kPhotons = 40000;
  constexpr double g = 0.85;
  core::RandomStream random{11, 0};
  int through = 0;
  for (int i = 0; i < kPhotons; ++i) {
    double at = 0, down = sine;  // optical depth from the top, cosine downwards
    for (;;) {
      at -= down * std::log(1 - random.nextUnit());
      if (at >= depth) ++through;
      if (at >= depth || at < 0) break;
      const double s = (1 - g * g) / (1 - g + 2 * g * random.nextUnit());
      const double cosine = std::clamp((1 + g * g - s * s) / (2 * g), -1.0, 1.0);
      const double turn = std::cos(2 * 3.141592653589793 * random.nextUnit());
      down =
          std::clamp(down * cosine + std::sqrt((1 - down * down) * (1 - cosine * cosine)) * turn, -1.0, 1.0);
    }
  }
  return through / static_cast<double>(kPhotons);
}

TEST(CloudForm, anOvercastSkyDimsTheLandByItsOpticalDepth) {
  // Below a whole deck of optical depths 2 to 60 (straight up), sun at 20, 40 and 70 degrees: the sun's light
  // on level ground within 15 % of that of photons; without cover it is that below single clouds.
  for (const double elevation : {20.0, 40.0, 70.0}) {
    const double sine = std::sin(elevation * 3.141592653589793 / 180);
    for (const double depth : {2.0, 6.0, 20.0, 60.0}) {
      const double exact = transmittedByPhotons(depth, sine);
      EXPECT_NEAR(f64::sunBelowLayers(depth / sine, sine, 1) / exact, 1, 0.15) << elevation << ' ' << depth;
      EXPECT_EQ(f64::sunBelowLayers(depth, sine, 0), f64::sunBelowCloud(depth));
    }
  }
  EXPECT_DOUBLE_EQ(f64::sunBelowLayers(0, 0.5, 1), 1);
}

TEST(CloudForm, sheetsCoverTheSkyAndHeapsLeaveGaps) {
  // Share of columns that are cloud (optical depth above .1) at covers of .5 and 1.
  struct Expected {
    double half[2], whole[2];
  };
  constexpr std::array<Expected, 7> kExpected{{{{0.3, 1}, {0.95, 1}},
                                               {{0.05, 0.9}, {0.5, 1}},
                                               {{0, 0.5}, {0, 0.95}},
                                               {{0.3, 1}, {0.95, 1}},
                                               {{0.02, 0.9}, {0.3, 1}},
                                               {{0.3, 1}, {0.95, 1}},
                                               {{0.02, 0.5}, {0.3, 1}}}};
  core::RandomStream random{13, 0};
  for (std::size_t g = 0; g < kUsual.size(); ++g) {
    for (const bool whole : {false, true}) {
      const clouds::CloudField field(test::quickNoise(), mediumOf(kUsual[g], whole ? 1 : 0.5));
      int clouded = 0;
      constexpr int kColumns = 600, kSamples = 40;
      for (int i = 0; i < kColumns; ++i) {
        const double x = random.nextUnit() * 1e5, z = random.nextUnit() * 1e5;
        const double step = field.layer().thickness / kSamples;
        double depth = 0;
        for (int k = 0; k < kSamples; ++k) {
          depth += static_cast<double>(
                       field.densityInFloat({x, field.layer().cloudHeight + (k + 0.5) * step, z})) *
                   step * field.layer().extinction;
        }
        clouded += depth > 0.1;
      }
      const double share = clouded / static_cast<double>(kColumns);
      const double* limits = whole ? kExpected[g].whole : kExpected[g].half;
      const std::string_view name = weather::kGenusNames[static_cast<std::size_t>(kUsual[g].genus)];
      EXPECT_GE(share, limits[0]) << name << (whole ? " at 1" : " at .5");
      EXPECT_LE(share, limits[1]) << name << (whole ? " at 1" : " at .5");
    }
  }
}

}  // namespace
}  // namespace skydrop
