// The clouds' medium: C07, C08, the processor's share of C05, C06, C17 and C18.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "skydrop/clouds/cloud_field.h"
#include "skydrop/clouds/noise_textures.h"
#include "skydrop/core/error.h"
#include "skydrop/core/hash.h"
#include "skydrop/core/settings_table.h"
#include "skydrop/core/shared.h"
#include "skydrop/core/wind.h"
#include "support/cloud_noise.h"
#include "support/margin.h"

namespace skydrop::clouds {
namespace {

namespace f32 = core::shared::f32;
namespace f64 = core::shared::f64;

using test::quickNoise;

glm::dvec3 randomPlace(core::RandomStream& random, double extent) {
  return {random.nextUnit() * extent, 1400 + random.nextUnit() * 2200, random.nextUnit() * extent};
}

double occupiedShare(const CloudField& field) {
  core::RandomStream random{3, 0};
  constexpr int kPlaces = 20000;
  int occupied = 0;
  for (int i = 0; i < kPlaces; ++i) occupied += field.density(randomPlace(random, 50000)) > 0;
  return occupied / static_cast<double>(kPlaces);
}

TEST(CloudMedium, densityStaysBetweenNothingAndOneForAnySettings) {
  // Every corner of the settings that shape the medium, at random places; settings beyond their range are
  // refused.
  core::RandomStream random{1, 0};
  for (int corner = 0; corner < 256; ++corner) {
    const auto end = [&](int bit, double low, double high) { return (corner >> bit & 1) != 0 ? high : low; };
    CloudSettings settings;
    settings.layers[0].densityThreshold = end(0, 0, 0.95);
    settings.layers[0].scale = end(1, 0.1, 4);
    settings.layers[0].higherScale = end(2, 2, 80);
    settings.layers[0].weatherScale = end(3, 0.005, 0.1);
    settings.layers[0].coverage = end(4, 0, 1);
    settings.layers[0].typeShift = end(5, -1, 1);
    settings.layers[0].erosion = end(6, 0, 0.9);
    settings.layers[0].thickness = end(7, 50, 6000);
    const CloudField field(quickNoise(), settings);
    for (int i = 0; i < 300; ++i) {
      const double density = field.density(randomPlace(random, 1e6));
      ASSERT_TRUE(density >= 0 && density <= 1) << corner << ": " << density;
    }
  }
  CloudSettings settings;
  const core::SettingsTable table(settings);
  for (const char* wrong : {"layers.0.extinction=-1", "layers.0.extinction=nan",
                            "layers.0.densityThreshold=1", "layers.0.thickness=0", "layers.0.scale=0"}) {
    EXPECT_THROW(core::setField(table, wrong), core::RangeError) << wrong;
  }
}

TEST(CloudMedium, theShapesEstimateIsTheShapeWhereThereIsCloudAndFallsBelowNothingElsewhere) {
  // For any base, height and weather, within 1e-12 of [0, 1]: so a march may take it for both.
  core::RandomStream random{9, 0};
  int cloudy = 0;
  for (int i = 0; i < 20000; ++i) {
    const f64::CloudMedium medium{0.95 * random.nextUnit(), random.nextUnit(), 2 * random.nextUnit() - 1,
                                  0.3};
    const double height = 1.4 * random.nextUnit() - 0.2, base = 1.2 * random.nextUnit() - 0.1;
    const double coverage = random.nextUnit(), type = random.nextUnit();
    const double shape = f64::cloudShapeDensity(medium, height, {coverage, 0, type, 1}, base);
    const double estimate = f64::cloudShapeEstimate(medium, height, coverage, type, base);
    ASSERT_NEAR(std::max(estimate, 0.0), shape, 1e-12);
    cloudy += shape > 0;
  }
  EXPECT_GT(cloudy, 500) << "proves little";
}

TEST(CloudMedium, remapWithEqualBoundsIsAStep) {
  for (const double at : {-1.0, 0.0, 0.3, 1.0}) {
    EXPECT_EQ(f64::remapClamped(at - 1e-9, at, at, 0, 1), 0);
    EXPECT_EQ(f64::remapClamped(at, at, at, 0, 1), 1);
    EXPECT_EQ(f32::remapClamped(static_cast<float>(at), static_cast<float>(at), static_cast<float>(at), 0, 1),
              1);
  }
}

TEST(CloudMedium, cloudsGrowWithCoverageAndNoneIsLeftAtNone) {
  CloudSettings settings;
  settings.layers[0].densityThreshold = 0.3;  // the quick noise is thinner than the real one
  double before = -1;
  for (const double coverage : {0.0, 0.1, 0.25, 0.5, 0.75, 1.0}) {
    settings.layers[0].coverage = coverage;
    const double share = occupiedShare(CloudField(quickNoise(), settings));
    EXPECT_GE(share, before) << coverage;
    EXPECT_TRUE(coverage > 0 || share == 0) << share;
    before = share;
  }
  EXPECT_GT(before, 0.1) << "the whole sky stays clear";
  // Also where the weather map asks for more than the sky has.
  const f64::CloudMedium medium{0.5, 1.0, 0, 0};
  const double full = f64::cloudShapeDensity(medium, 0.3, {1.0, 0, 0.5, 1}, 0.9);
  EXPECT_EQ(full, f64::cloudShapeDensity(medium, 0.3, {1.5, 0, 0.5, 1}, 0.9));
  EXPECT_TRUE(full > 0 && full <= 1);
}

TEST(Stability, C07_everyTypesProfileIsZeroOutsideAndPeaksAtOne) {
  for (int i = -5; i <= 105; ++i) {
    const double type = i / 100.0;
    double peak = 0;
    for (int k = -200; k <= 1200; ++k) {
      const double height = k / 1000.0, share = f64::cloudProfile(height, type);
      ASSERT_TRUE(share >= 0 && share <= 1) << type << " at " << height;
      ASSERT_TRUE((height > 0 && height < 1) || share == 0) << type << " at " << height;
      peak = std::max(peak, share);
    }
    EXPECT_TRUE(test::holds("C07", test::apart(peak, 1), test::atMost(0.01), "of 1")) << type;
  }
}

TEST(Stability, C08_thereIsNothingExactlyOnTheBorders) {
  test::noFaults("C08", "differences");
  CloudSettings settings;
  settings.layers[0].coverage = 1;
  settings.layers[0].densityThreshold = 0;
  const CloudField field(quickNoise(), settings);
  core::RandomStream random{2, 0};
  for (int i = 0; i < 1000; ++i) {
    glm::dvec3 place = randomPlace(random, 50000);
    const double base = field.layer().cloudHeight;
    for (const double height : {base, base + field.layer().thickness}) {
      place.y = height;
      EXPECT_EQ(field.density(place), 0);
      EXPECT_EQ(field.densityInFloat(place), 0);
    }
  }
}

TEST(CloudMedium, theFieldFarOutIsTheFieldAtTheOrigin) {
  // The weather map's period holds whole periods of the others here, so the field repeats with it. Doubles
  // resolve 2e-6 of a texel at 1e9 m.
  CloudSettings settings;
  settings.layers[0].densityThreshold = 0.3;
  settings.layers[0].scale = 0.6;
  settings.layers[0].weatherScale = 0.02;
  settings.fadeDistance = 24000;
  const double period = 1e9 / 50000 * weatherPeriod(settings.layers[0], settings.fadeDistance);
  ASSERT_NEAR(std::remainder(period, shapePeriod(settings.layers[0])), 0, 1e-6);
  ASSERT_NEAR(std::remainder(period, detailPeriod(settings.layers[0])), 0, 1e-6);
  const CloudField field(quickNoise(), settings);
  core::RandomStream random{4, 0};
  int occupied = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 place = randomPlace(random, 50000);
    const double here = field.density(place);
    ASSERT_NEAR(field.density(place + glm::dvec3(period, 0, -period)), here, 1e-5);
    occupied += here > 0;
  }
  EXPECT_GT(occupied, 200);
}

TEST(CloudMedium, aMonthOfWindMovesTheFieldAndNothingElse) {
  const CloudSettings settings;
  CloudField field(quickNoise(), settings);
  const CloudField still(quickNoise(), settings);
  const glm::dvec2 drift = core::windDrift({.speed = 17.3, .direction = 250}, 30.0 * 86400);
  EXPECT_GT(drift.x, 0) << "wind from the west-southwest blows east";
  EXPECT_LT(drift.y, 0) << "and north";
  field.setDrift(drift);
  core::RandomStream random{5, 0};
  for (int i = 0; i < 5000; ++i) {
    const glm::dvec3 place = randomPlace(random, 50000);
    ASSERT_NEAR(field.density(place + glm::dvec3(drift.x, 0, drift.y)), still.density(place), 1e-6);
  }
}

TEST(CloudMedium, floatsGiveTheDensityOfDoubles) {
  // Texel coordinates of floats are good to 1e-5 of a texel, and erosion multiplies by up to ten.
  const CloudField field(quickNoise(), CloudSettings{});
  core::RandomStream random{6, 0};
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 place = randomPlace(random, 50000);
    ASSERT_NEAR(field.densityInFloat(place), field.density(place), 2e-4);
  }
}

TEST(CloudMedium, erosionOnlyTakesAway) {
  const f64::CloudMedium medium{0.5, 0.8, 0, 0.9};
  for (int i = 0; i <= 1000; ++i) {
    const double density = i / 1000.0;
    for (const double detail : {0.0, 0.3, 1.0}) {
      for (const double height : {0.01, 0.05, 0.5}) {
        const double left = f64::erodedDensity(medium, height, density, detail);
        ASSERT_TRUE(left >= 0 && left <= density) << density << " " << detail;
      }
    }
  }
}

TEST(CloudMedium, foreignNoiseOfAnotherShapeIsRefused) {
  const core::TextureData good = makeNoise(NoiseTexture::detail, 0),
                          map = makeNoise(NoiseTexture::weather, 0);
  EXPECT_THROW(packCloudNoise(map, good, map), core::RangeError);
  EXPECT_THROW(packCloudNoise(good, good, good), core::RangeError);
  EXPECT_THROW(packCloudNoise(core::TextureData(core::TexelFormat::r8, 32, 32, 32), good, map),
               core::RangeError);
  EXPECT_THROW(packCloudNoise(core::TextureData(core::TexelFormat::rgba8, 24, 24, 24), good, map),
               core::RangeError);
  EXPECT_THROW(packCloudNoise(core::TextureData(core::TexelFormat::rgba8, 32, 32, 16), good, map),
               core::RangeError);
}

}  // namespace
}  // namespace skydrop::clouds
