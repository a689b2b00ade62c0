// Strides through clear air: measured, not proven, so they are tried out against single steps wherever
// settings and noise may lead them.
#include "skydrop/clouds/clear_air.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <memory>
#include <numbers>

#include "skydrop/core/hash.h"
#include "skydrop/core/settings_table.h"
#include "skydrop/core/shared.h"
#include "support/cloud_noise.h"

namespace skydrop::clouds {
namespace {

using Noise = std::shared_ptr<const PackedCloudNoise>;

constexpr double kStepM = 16;

// As shaders/clouds/march.glsl: midpoint samples of one length, and on by a step or by as many as the air is
// clear. What is left of light after the way, and the samples that it took.
struct Passed {
  double transmittance = 1;
  int samples = 0;
};

Passed passedBy(const CloudField& field, const ClearAir& air, const glm::dvec3& from,
                const glm::dvec3& direction, double wayM) {
  double depth = 0;
  Passed passed;
  for (double at = 0; at < wayM; ++passed.samples) {
    const glm::dvec3 place = from + direction * (at + 0.5 * kStepM);
    depth += field.density(place) * field.layer().extinction * kStepM;
    const double stride =
        std::floor((air.leastShape - field.shapeEstimateInFloat(place)) * air.slopeM / kStepM);
    at += kStepM * std::max(1.0, stride);
  }
  passed.transmittance = std::exp(-depth);
  return passed;
}

// Rays through the layer at random, by strides and by single steps.
struct Comparison {
  int rays = 0, cloudy = 0, holes = 0;  // with an opacity above .02; that lose more than half of it
  double error = 0;                     // sum over rays
  double samples = 0, singleSamples = 0;

  void add(const Noise& noise, const CloudSettings& settings, int count, core::RandomStream& random) {
    const CloudField field(noise, settings);
    const ClearAir air = measureClearAir(noise, settings);
    EXPECT_TRUE(std::isfinite(air.slopeM) && air.slopeM >= 0) << air.slopeM;
    EXPECT_TRUE(air.leastShape >= 0 && air.leastShape <= settings.layers[0].erosion) << air.leastShape;
    for (int i = 0; i < count; ++i) {
      const double up = 0.05 + 0.9 * random.nextUnit(), azimuth = 2 * std::numbers::pi * random.nextUnit();
      const double level = std::sqrt(1 - up * up);
      const glm::dvec3 direction(level * std::cos(azimuth), up, level * std::sin(azimuth));
      const glm::dvec3 from(1e5 * random.nextUnit(), settings.layers[0].cloudHeight, 1e5 * random.nextUnit());
      const double way = std::min(settings.layers[0].thickness / up, 12000.0);
      const Passed strides = passedBy(field, air, from, direction, way),
                   steps = passedBy(field, {}, from, direction, way);
      ++rays;
      error += std::abs(strides.transmittance - steps.transmittance);
      cloudy += steps.transmittance < 0.98;
      holes += steps.transmittance < 0.98 && 1 - strides.transmittance < 0.5 * (1 - steps.transmittance);
      samples += strides.samples;
      singleSamples += steps.samples;
    }
  }
};

// Each row of the layer that shapes it, anywhere on its slider.
CloudSettings anyWeather(core::RandomStream& random) {
  CloudSettings settings;
  const core::SettingsTable table(settings);
  for (const core::Field& field : table.fields()) {
    if (field.group != "layers.0") continue;
    const double share = random.nextUnit();
    field.set(field.logarithmic ? field.sliderMin * std::pow(field.sliderMax / field.sliderMin, share)
                                : field.sliderMin + (field.sliderMax - field.sliderMin) * share);
  }
  return settings;
}

// Texels that have nothing to do with their neighbours: what a player's own file may hold.
Noise roughNoise() {
  PackedCloudNoise noise;
  noise.shapeSide = noise.detailSide = 32;
  noise.weatherSide = 64;
  core::RandomStream random{5, 0};
  const auto fill = [&](std::vector<float>& texels, std::size_t count) {
    texels.resize(count);
    for (float& texel : texels) texel = static_cast<float>(random.nextUnit());
  };
  fill(noise.base, 32 * 32 * 32);
  fill(noise.detail, 32 * 32 * 32);
  noise.weather.resize(64 * 64);
  for (glm::vec3& texel : noise.weather) texel = glm::vec3(random.nextUnit(), 0, random.nextUnit());
  return std::make_shared<const PackedCloudNoise>(std::move(noise));
}

TEST(ClearAir, stridesFindTheCloudThatSingleStepsFindInAnyWeather) {
  // 60 weathers anywhere on their sliders, with noise as the game makes it and with texels that have nothing
  // to do with each other: transmittance is off by less than .001 in the mean, of a hundred rays through
  // cloud less than one loses half of it, and strides save something.
  for (const Noise& noise : {test::quickNoise(), roughNoise()}) {
    core::RandomStream random{7, 0};
    Comparison all;
    for (int i = 0; i < 60; ++i) all.add(noise, anyWeather(random), 40, random);
    EXPECT_GT(all.cloudy, 300) << "proves little";
    EXPECT_LT(all.error / all.rays, 0.001);
    EXPECT_LT(all.holes, 0.01 * all.cloudy);
    EXPECT_LT(all.samples, 0.8 * all.singleSamples);
    RecordProperty("meanError", std::to_string(all.error / all.rays));
    RecordProperty("holes", all.holes);
    RecordProperty("shareOfSamples", std::to_string(all.samples / all.singleSamples));
  }
}

TEST(ClearAir, evenWearLeavesAsMuchCloudAsTheDetailItStandsFor) {
  // In weathers anywhere on their sliders: the mean density of 40 000 places with the detail looked up,
  // against that with the constant. Within 4 % of each other where there is cloud enough to tell; without
  // erosion it does not matter.
  core::RandomStream random{11, 0};
  int told = 0;
  double worst = 0;
  for (int i = 0; i < 12; ++i) {
    const CloudSettings settings = anyWeather(random);
    const CloudLayerSettings& layer = settings.layers[0];
    const double wear = measureClearAir(test::quickNoise(), settings).evenWear;
    ASSERT_TRUE(wear >= 0 && wear <= 1) << wear;
    const CloudField field(test::quickNoise(), settings);
    const core::shared::f64::CloudMedium medium{layer.densityThreshold, layer.coverage, layer.typeShift,
                                                layer.erosion};
    double worn = 0, even = 0;
    int places = 0;
    for (int k = 0; k < 40000; ++k) {
      const double height = random.nextUnit();
      const glm::dvec3 place(1e5 * random.nextUnit(), layer.cloudHeight + height * layer.thickness,
                             1e5 * random.nextUnit());
      const double shape = field.shapeEstimateInFloat(place);
      if (!(shape > 0)) continue;
      ++places;
      worn += field.density(place);
      even += core::shared::f64::erodedDensity(medium, height, shape, wear);
    }
    if (places < 1500 || worn / places < 0.02) continue;
    ++told;
    worst = std::max(worst, std::abs(even / worn - 1));
    EXPECT_NEAR(even / worn, 1, 0.04) << places << " places of mean density " << worn / places;
  }
  RecordProperty("worst", std::to_string(worst));
  EXPECT_GE(told, 4) << "proves little";
}

TEST(ClearAir, aRougherNoiseAndASmallerScaleMakeShorterStrides) {
  CloudSettings settings = test::cloudySettings();
  const double slope = measureClearAir(test::quickNoise(), settings).slopeM;
  EXPECT_GT(slope, 0);
  EXPECT_LT(measureClearAir(roughNoise(), settings).slopeM, slope);
  settings.layers[0].scale *= 3;
  EXPECT_LT(measureClearAir(test::quickNoise(), settings).slopeM, slope);
}

TEST(ClearAir, withoutErosionThereMayBeCloudWhereverTheShapeIsAboveNothing) {
  CloudSettings settings = test::cloudySettings();
  settings.layers[0].erosion = 0;
  EXPECT_EQ(measureClearAir(test::quickNoise(), settings).leastShape, 0);
  EXPECT_GT(measureClearAir(test::quickNoise(), settings).slopeM, 0);
}

TEST(ClearAir, whereNoWayLeadsIntoCloudItGoesStepByStep) {
  CloudSettings settings;
  settings.layers[0].coverage = 0;
  EXPECT_EQ(measureClearAir(test::quickNoise(), settings).slopeM, 0);
}

}  // namespace
}  // namespace skydrop::clouds
