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
#include "skydrop/core/hash.h"
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

// Cells along a side: a sixteenth of the cells under a sanitizer, which sees the same code run.
constexpr int kTestedSide = test::kInstrumented ? LightVolume::kSide / 4 : LightVolume::kSide;

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

TEST(LightVolume, aPartHasTheLightOfTheWholeButForItsEdge) {
  // A quarter of a period across, over the period's border: light of sun and sky more than 8 cells from its
  // edge within 3 % RMS of the whole's.
  const CloudField field = quickField();
  const LightVolume whole(field, sunAt(35));
  constexpr int kCells = 64, kEdge = 8;
  const glm::ivec2 first(LightVolume::kSide - 20, 100);
  const std::vector<LightVolume::Texel> part =
      LightVolume::part(field, sunAt(35), LightVolume::kSide, first, kCells);
  ASSERT_EQ(part.size(), std::size_t{kCells} * kCells * LightVolume::kRows);
  glm::dvec2 off(0), sum(0);
  for (int z = kEdge; z < kCells - kEdge; ++z) {
    for (int row = 0; row < LightVolume::kRows; ++row) {
      for (int x = kEdge; x < kCells - kEdge; ++x) {
        const auto index = [row](int cellX, int cellZ, int side) {
          return static_cast<std::size_t>((cellZ * LightVolume::kRows + row) * side + cellX);
        };
        const LightVolume::Texel
            &a = part[index(x, z, kCells)],
            &b = whole.texels()[index((first.x + x) % LightVolume::kSide, first.y + z, LightVolume::kSide)];
        const glm::dvec2 of(b.sun, b.sky), by = glm::dvec2(a.sun, a.sky) - of;
        off += by * by;
        sum += of * of;
      }
    }
  }
  const glm::dvec2 error = glm::sqrt(off / sum);
  RecordProperty("sun", std::to_string(error.x));
  RecordProperty("sky", std::to_string(error.y));
  EXPECT_LT(error.x, 0.05);
  EXPECT_LT(error.y, 0.01);
}

TEST(LightVolume, cellsOfOtherWidthsHaveTheSameLightInTheMean) {
  // In cloud: of the sun within 2 %, of the sky within 1 %, with half as many cells a side and with a
  // quarter.
  const CloudField field = quickField();
  const double period = weatherPeriod(field.medium());
  const auto means = [&](int side) {
    const LightVolume volume(field, sunAt(35), side);
    EXPECT_EQ(volume.side(), side);
    glm::dvec2 sum(0);
    int count = 0;
    core::RandomStream random{5, 0};
    while (count < 3000) {
      const glm::dvec3 place(random.nextUnit() * period,
                             field.layer().cloudHeight + random.nextUnit() * field.layer().thickness,
                             random.nextUnit() * period);
      if (field.density(place) <= 0) continue;
      const LightVolume::Texel texel = volume.at(place);
      sum += glm::dvec2(texel.sun, texel.sky);
      ++count;
    }
    return sum / 3000.0;
  };
  const glm::dvec2 usual = means(256);
  for (const int side : {128, 64}) {
    const glm::dvec2 ratio = means(side) / usual;
    RecordProperty("sun" + std::to_string(side), std::to_string(ratio.x));
    EXPECT_NEAR(ratio.x, 1, 0.02) << side;
    EXPECT_NEAR(ratio.y, 1, 0.01) << side;
  }
}

TEST(LightVolume, aStopLeavesItUnsolved) {
  std::stop_source stop;
  stop.request_stop();
  const CloudField field = quickField();
  EXPECT_FALSE(LightVolume(field, sunAt(40), LightVolume::kSide, stop.get_token()).isSolved());
}

TEST(Stability, C86_volumesOfExtinction0And10AndOfAThinLayer) {
  // Finite, and even light is even: no cloud, walls, and rows of 3 m.
  test::noFaults("C86", "violations");
  CloudSettings settings = cloudySettings();
  for (const auto& [extinction, thickness] : {std::pair(0.0, 1800.0), {10.0, 1800.0}, {0.08, 50.0}}) {
    settings.layers[0].extinction = extinction;
    settings.layers[0].thickness = thickness;
    const LightVolume volume(CloudField(quickNoise(), settings), sunAt(40), kTestedSide);
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
    const LightVolume volume(field, toSun, kTestedSide);
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

TEST(Stability, C90_aVolumeOfOneCloudOfOneCell) {
  // A cloud that is no wider than a cell or two, in cells of any size: light of the sun in it, finite, no
  // brighter than what came in; and a quarter of a period away neither light of the sun nor less of the sky.
  test::noFaults("C90", "violations");
  PackedCloudNoise noise;
  noise.shapeSide = noise.detailSide = 32;
  noise.weatherSide = 64;
  noise.base.assign(32 * 32 * 32, 1.0f);
  noise.detail.assign(32 * 32 * 32, 0.5f);
  noise.weather.assign(64 * 64, glm::vec3(0));
  constexpr int kTexel = 20;
  noise.weather[kTexel * 64 + kTexel] = glm::vec3(1);
  CloudSettings settings;
  settings.layers[0].coverage = 0.9;
  settings.layers[0].erosion = 0;
  const CloudField field(std::make_shared<const PackedCloudNoise>(std::move(noise)), settings);
  const double period = weatherPeriod(field.medium()), middle = (kTexel + 0.5) / 64 * period;
  for (const int side : {32, 64, 128, 256}) {
    const LightVolume volume(field, sunAt(40), side);
    float most = 0;
    for (const LightVolume::Texel& texel : volume.texels()) {
      ASSERT_TRUE(isFinite(texel)) << side;
      most = std::max(most, texel.sun);
    }
    EXPECT_GT(most, 1e-4f) << side;
    EXPECT_LT(most, 1 / glm::pi<float>()) << side;
    const LightVolume::Texel away = volume.at({middle + 0.25 * period, 2400, middle + 0.25 * period});
    EXPECT_LT(away.sun, 1e-3f * most) << side;
    EXPECT_NEAR(away.sky * glm::pi<float>(), 0.5f, 1e-3f) << side;
  }
}

}  // namespace
}  // namespace skydrop::clouds
