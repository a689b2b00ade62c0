// The light volume on the processor: C86 to C88.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>
#include <memory>

#include "skydrop/clouds/light_volume.h"
#include "skydrop/clouds/path_tracer.h"
#include "skydrop/clouds/reference_march.h"
#include "skydrop/core/shared.h"
#include "support/cloud_noise.h"
#include "support/instrumented.h"
#include "support/margin.h"

namespace skydrop::clouds {
namespace {

namespace f64 = core::shared::f64;
using test::cloudySettings, test::quickNoise;

glm::dvec3 sunAt(double degrees) {
  return {std::cos(glm::radians(degrees)), std::sin(glm::radians(degrees)), 0};
}

CloudField quickField() { return {quickNoise(), cloudySettings()}; }

bool isFinite(const LightVolume::Texel& texel) {
  return std::isfinite(texel.sun) && std::isfinite(texel.sky) && texel.sun >= 0 && texel.sky >= 0 &&
         texel.ground() >= 0;
}

TEST(LightVolume, cloudTakesLightOfTheSkyBelowItAndGivesItAbove) {
  // The rest of even light is the ground's: all of it together as bright as outside. In a field of clouds the
  // highest row has more than half of its light from the sky, the lowest less.
  const CloudField field = quickField();
  const LightVolume volume(field, sunAt(40));
  ASSERT_TRUE(volume.isSolved());
  double top = 0, base = 0;
  const std::span<const LightVolume::Texel> texels = volume.texels();
  for (std::size_t i = 0; i < texels.size(); ++i) {
    ASSERT_TRUE(isFinite(texels[i]));
    const std::size_t row = i / LightVolume::kSide % LightVolume::kRows;
    if (row == 0) base += static_cast<double>(texels[i].sky);
    if (row == LightVolume::kRows - 1) top += static_cast<double>(texels[i].sky);
  }
  const double half = 0.5 / glm::pi<double>() * LightVolume::kSide * LightVolume::kSide;
  EXPECT_GT(top, 1.02 * half);
  EXPECT_LT(base, 0.98 * half);
}

TEST(LightVolume, withoutCloudNothingIsScattered) {
  CloudSettings clear = cloudySettings();
  clear.layers[0].coverage = 0;
  const LightVolume volume(CloudField(quickNoise(), clear), sunAt(40));
  for (const LightVolume::Texel& texel : volume.texels()) {
    ASSERT_EQ(texel.sun, 0);
    ASSERT_NEAR(texel.sky * glm::pi<float>(), 0.5f, 1e-4f);
  }
}

TEST(LightVolume, itIsNearerToTracedPathsThanOctaves) {
  // Of 48 rays in clouds, of sun, sky and ground: at most two thirds, a third and a third of the octaves' RMS
  // error.
  const CloudField field = quickField();
  const glm::dvec3 toSun = sunAt(35);
  const LightVolume volume(field, toSun);
  MarchMedium medium = mediumOf(field);
  medium.isShell = false;
  std::vector<MarchRay> rays;
  for (int i = 0; i < 48; ++i) {
    const double azimuth = 0.7 * i, sine = 0.25 + 0.015 * i;
    const double level = std::sqrt(1 - sine * sine);
    const glm::dvec3 direction(level * std::cos(azimuth), i % 2 == 0 ? sine : -sine,
                               level * std::sin(azimuth));
    rays.push_back({{1100.0 * i, i % 2 == 0 ? 900.0 : 3900.0, 300.0 * i}, direction, 0, 12000});
  }
  const CloudLayerSettings& layer = field.layer();
  const auto traced =
      traceRays(tracedMediumOf(field), tracedPhaseOf(layer), toSun, rays, test::repetitions(1500), 1);
  const MarchLight light{toSun, layer.anisotropy, layer.forwardShare};
  const ScatteredLight ofVolume = [&](const LitPlace& at) {
    const LightVolume::Texel texel = volume.at(at.place);
    return glm::dvec3(
        f64::scatteredSunOfVolume(f64::volumePhases(at.sunCosine, layer.anisotropy, layer.forwardShare),
                                  at.sunDepth, static_cast<double>(texel.sun), at.extinction,
                                  layer.thickness / LightVolume::kRows),
        texel.sky, texel.ground());
  };
  glm::dvec3 errors[2] = {};
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const TracedLight& judge = traced[i].mean;
    const MarchResult marched[2] = {referenceMarch(medium, light, rays[i], {256, 32}),
                                    referenceMarch(medium, light, rays[i], {256, 32}, ofVolume)};
    for (int k = 0; k < 2; ++k) {
      const glm::dvec3 off(marched[k].sun - judge.sun, marched[k].sky - judge.sky,
                           marched[k].ground - judge.ground);
      errors[k] += off * off;
    }
  }
  const glm::dvec3 ratio = glm::sqrt(errors[1] / errors[0]);
  RecordProperty("ofSun", std::to_string(ratio.x));
  EXPECT_LT(ratio.x, 0.67) << ratio.x << " " << ratio.y << " " << ratio.z;
  EXPECT_LT(ratio.y, 0.34);
  EXPECT_LT(ratio.z, 0.34);
}

TEST(LightVolume, aStopLeavesItUnsolved) {
  std::stop_source stop;
  stop.request_stop();
  const CloudField field = quickField();
  EXPECT_FALSE(LightVolume(field, sunAt(40), stop.get_token()).isSolved());
}

TEST(Stability, C86_volumesOfExtinction0And10AndOfAThinLayer) {
  // Finite, and even light is even: no cloud, walls, and rows of 3 m.
  test::noFaults("C86", "violations");
  CloudSettings settings = cloudySettings();
  for (const auto& [extinction, thickness] : {std::pair(0.0, 1800.0), {10.0, 1800.0}, {0.08, 50.0}}) {
    settings.layers[0].extinction = extinction;
    settings.layers[0].thickness = thickness;
    const LightVolume volume(CloudField(quickNoise(), settings), sunAt(40));
    for (const LightVolume::Texel& texel : volume.texels()) {
      ASSERT_TRUE(isFinite(texel)) << extinction;
      ASSERT_LT(texel.sun, 1) << extinction;
    }
  }
}

TEST(Stability, C87_volumesWithTheSunAtTheHorizonAndAtTheZenith) {
  test::noFaults("C87", "violations");
  const CloudField field = quickField();
  const auto brightest = [&](const glm::dvec3& toSun) {
    float most = 0;
    const LightVolume volume(field, toSun);
    for (const LightVolume::Texel& texel : volume.texels()) {
      EXPECT_TRUE(isFinite(texel));
      most = std::max(most, texel.sun);
    }
    return most;
  };
  EXPECT_GT(brightest({0, 1, 0}), 0.01f);
  EXPECT_GT(brightest(sunAt(0.01)), 0);
  EXPECT_EQ(brightest({1, 0, 0}), 0);
  EXPECT_EQ(brightest(sunAt(-5)), 0);
}

TEST(Stability, C88_volumesRepeatWithoutASeamToFarAway) {
  // A whole number of periods away, to 1e9 m: within rounding of a place there. Across the period's border
  // light changes no more than elsewhere.
  const CloudField field = quickField();
  const LightVolume volume(field, sunAt(20));
  const double period = weatherPeriod(field.medium()), cell = period / LightVolume::kSide;
  const double far = std::round(1e9 / period) * period;
  double atBorder = 0, inside = 0;
  for (int i = 0; i < LightVolume::kSide; ++i) {
    const auto at = [&](double x) { return volume.at({x, 2200, (i + 0.3) * cell}); };
    EXPECT_TRUE(
        test::holds("C88", test::apart(at(100).sun, at(far + 100).sun), test::atMost(1e-4f), "light"));
    atBorder += std::abs(static_cast<double>(at(-0.5 * cell).sun - at(0.5 * cell).sun));
    inside += std::abs(static_cast<double>(at(19.5 * cell).sun - at(20.5 * cell).sun));
  }
  EXPECT_TRUE(test::holds("C88", atBorder, test::below(3 * inside + 1e-3), "light"));
}

}  // namespace
}  // namespace skydrop::clouds
