// What a layer leaves of the light of sun and sky, on the processor.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "skydrop/clouds/raised_sun.h"
#include "skydrop/clouds/sky_cover.h"
#include "skydrop/clouds/sun_depth.h"
#include "skydrop/core/hash.h"
#include "skydrop/core/shared.h"
#include "support/cloud_noise.h"

namespace skydrop::clouds {
namespace {

using test::cloudySettings, test::quickNoise;

glm::dvec3 direction(double elevation, double azimuth) {
  return {std::cos(elevation) * std::cos(azimuth), std::sin(elevation),
          std::cos(elevation) * std::sin(azimuth)};
}

// Optical depth from a place below the layer by even steps of doubles.
double denseDepth(const CloudField& field, const glm::dvec3& place, const glm::dvec3& towards, int steps) {
  const CloudLayerSettings& layer = field.layer();
  const double begin = std::max(0.0, layer.cloudHeight - place.y) / towards.y,
               way = (layer.cloudHeight + layer.thickness - place.y) / towards.y - begin;
  double depth = 0;
  for (int i = 0; i < steps; ++i) depth += field.density(place + towards * (begin + (i + 0.5) / steps * way));
  return depth * way / steps * layer.extinction;
}

TEST(CloudShade, ofTheSunIsThatOfManySteps) {
  // What the clouds leave of the sun (64 places, sun anywhere above 5 degrees) differs from that of 8000 even
  // steps by less than .01 RMS (half of that is measured).
  core::RandomStream random{4, 0};
  const CloudField field(quickNoise(), cloudySettings());
  double square = 0, shaded = 0;
  constexpr int kPlaces = 64;
  for (int i = 0; i < kPlaces; ++i) {
    const glm::dvec3 place(1e5 * random.nextUnit(), 3200 * random.nextUnit(), 1e5 * random.nextUnit());
    const glm::dvec3 toSun = direction(0.09 + 1.45 * random.nextUnit(), 6.28 * random.nextUnit());
    const auto left = [](double depth) { return core::shared::f64::sunBelowCloud(depth); };
    const double exact = left(denseDepth(field, place, toSun, 8000));
    const double error = left(sunOpticalDepth(field, place, toSun)) - exact;
    square += error * error;
    shaded += exact < 0.6;
  }
  RecordProperty("rms", std::to_string(std::sqrt(square / kPlaces)));
  EXPECT_GE(shaded, 10);
  EXPECT_LT(std::sqrt(square / kPlaces), 0.01);
}

TEST(CloudShade, isNoneAboveTheLayerAndFiniteAnywhere) {
  const CloudSettings settings = cloudySettings();
  const CloudField field(quickNoise(), settings);
  const double top = settings.layers[0].cloudHeight + settings.layers[0].thickness;
  for (const glm::dvec3& sun : {direction(1.57, 0), direction(0.3, 2), raisedSun(direction(-0.5, 1))}) {
    EXPECT_EQ(sunOpticalDepth(field, {10, top, 10}, sun), 0);
    EXPECT_EQ(sunOpticalDepth(field, {10, top + 1e7, 10}, sun), 0);
    for (const double far : {0.0, -1e9, 1e12}) {
      for (const double height : {-1e7, -1.0, 0.0, settings.layers[0].cloudHeight, top - 1e-9}) {
        const double depth = sunOpticalDepth(field, {far, height, -far}, sun);
        EXPECT_TRUE(std::isfinite(depth) && depth >= 0) << far << ' ' << height << ": " << depth;
      }
    }
  }
}

TEST(SkyCover, isTheCosineWeightedMeanOverTheSky) {
  // Against 24 x 48 directions, each with the depth of the column that stands where it meets the base, of 64
  // samples, at sea level below places a period apart at random: .04 RMS (half of that is measured), as a
  // cell of 64 has one column. Over all of a period the mean is right within .01.
  for (const double coverage : {0.5, 0.9}) {
    CloudSettings settings = cloudySettings();
    settings.layers[0].coverage = coverage;
    const CloudField field(quickNoise(), settings);
    const SkyCover cover(quickNoise(), settings);
    core::RandomStream random{5, 0};
    double square = 0, bias = 0;
    constexpr int kPlaces = 40, kElevations = 24, kAzimuths = 48;
    for (int i = 0; i < kPlaces; ++i) {
      const glm::dvec2 place(cover.periodM() * random.nextUnit(), cover.periodM() * random.nextUnit());
      double sum = 0, weights = 0;
      for (int e = 0; e < kElevations; ++e) {
        const double elevation = (e + 0.5) / kElevations * std::numbers::pi / 2;
        const double weight = std::sin(elevation) * std::cos(elevation);  // cosine times solid angle
        for (int a = 0; a < kAzimuths; ++a) {
          const glm::dvec3 towards = direction(elevation, (a + 0.5) / kAzimuths * 2 * std::numbers::pi);
          const glm::dvec3 base = towards * (settings.layers[0].cloudHeight / towards.y);
          const glm::dvec3 foot(place.x + base.x, 0, place.y + base.z);
          sum += weight * diffuseTransmittance(denseDepth(field, foot, {0, 1, 0}, 64));
          weights += weight;
        }
      }
      const double error = cover.share(place) - sum / weights;
      square += error * error / kPlaces;
      bias += error / kPlaces;
    }
    RecordProperty("rms", std::to_string(std::sqrt(square)));
    RecordProperty("bias", std::to_string(bias));
    EXPECT_LT(std::sqrt(square), 0.04) << coverage;
    EXPECT_LT(std::abs(bias), 0.01) << coverage;
  }
}

TEST(SkyCover, fallsWithTheCloudsAndRepeats) {
  CloudSettings settings = cloudySettings();
  double before = 1.0 + 1e-6;
  for (const double coverage : {0.0, 0.3, 0.6, 1.0}) {
    settings.layers[0].coverage = coverage;
    const SkyCover cover(quickNoise(), settings);
    double mean = 0;
    for (const float share : cover.shares()) {
      ASSERT_TRUE(share > 0 && share <= 1) << share;
      mean += static_cast<double>(share) / static_cast<double>(cover.shares().size());
    }
    EXPECT_LT(mean, before) << coverage;
    if (coverage == 0) {
      EXPECT_EQ(cover.shares(), std::vector<float>(cover.shares().size(), 1.0f));
    }
    before = mean;
    const double period = cover.periodM();
    for (const glm::dvec2& place :
         {glm::dvec2(0, 0), glm::dvec2(17.3, 12345.6), glm::dvec2(period, -period)}) {
      // 1e5 periods away places are a ten millionth of a metre apart.
      EXPECT_NEAR(cover.share(place), cover.share(place + period * 1e5), 1e-6);
    }
  }
  EXPECT_LT(before, 0.8) << "an overcast sky lets most of its light through";
}

TEST(SkyCover, isSoundAtTheEndsOfTheSettings) {
  const double kAlmostNone = 1e-6;
  for (const double height : {kAlmostNone, 8000.0}) {
    for (const double extinction : {kAlmostNone, 1.0}) {
      for (const double scale : {0.005, 0.1}) {
        CloudSettings settings = cloudySettings();
        settings.layers[0].cloudHeight = height;
        settings.layers[0].extinction = extinction;
        settings.layers[0].weatherScale = scale;
        const SkyCover cover(quickNoise(), settings);
        const auto isShare = [](float share) { return share > 0 && share <= 1; };
        EXPECT_TRUE(std::ranges::all_of(cover.shares(), isShare))
            << height << ' ' << extinction << ' ' << scale;
      }
    }
  }
}

}  // namespace
}  // namespace skydrop::clouds
