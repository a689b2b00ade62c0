// Clouds at the ends of every setting's range: nothing that a slider reaches breaks the medium, the march or
// the picture of where cloud can be.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "skydrop/clouds/occupancy.h"
#include "skydrop/clouds/reference_march.h"
#include "skydrop/core/hash.h"
#include "skydrop/core/settings_table.h"
#include "skydrop/core/shared.h"
#include "skydrop/core/wind.h"
#include "support/cloud_noise.h"

namespace skydrop::clouds {
namespace {

namespace f64 = core::shared::f64;

using test::cloudySettings, test::quickNoise;

bool isNumeric(const core::Field& field) {
  return field.kind == core::FieldKind::number || field.kind == core::FieldKind::integer;
}

// How many of the places hold cloud.
int expectSoundMedium(const CloudField& field, const CloudSettings& settings, const glm::dvec2& drift,
                      core::RandomStream& random) {
  const CloudLayerSettings& layer = field.layer();
  const Occupancy occupancy(*quickNoise(), settings);
  int clouds = 0;
  for (int i = 0; i < 500; ++i) {
    const glm::dvec3 place(random.nextUnit() * 2e5 - 1e5,
                           layer.cloudHeight + layer.thickness * random.nextUnit(),
                           random.nextUnit() * 2e5 - 1e5);
    const double density = field.density(place);
    const float inFloat = field.densityInFloat(place);
    EXPECT_TRUE(density >= 0 && density <= 1) << density;
    EXPECT_TRUE(inFloat >= 0 && inFloat <= 1) << inFloat;
    if (!(density > 0)) continue;
    ++clouds;
    EXPECT_EQ(occupancy.distance(occupancy.cellOf(place - glm::dvec3(drift.x, 0, drift.y))), 0);
  }
  return clouds;
}

// Finite, and no more light than there is to scatter.
void expectSoundMarch(const CloudField& field, core::RandomStream& random) {
  const CloudLayerSettings& layer = field.layer();
  const MarchMedium medium = mediumOf(field);
  for (int i = 0; i < 24; ++i) {
    const auto direction = [&] {
      return f64::directionOf(
          glm::dvec3(random.nextUnit() - 0.5, random.nextUnit() - 0.5, random.nextUnit() - 0.5), {0, 1, 0});
    };
    const MarchLight light{direction(), layer.anisotropy, layer.forwardShare};
    // From below, inside and above.
    const MarchRay ray{{0, layer.cloudHeight + layer.thickness * (i % 3 - 0.5), 1e4 * i}, direction()};
    const MarchResult result = referenceMarch(medium, light, ray, {64, 4});
    const f64::Vec4 phases =
        f64::cloudPhases(glm::dot(ray.direction, light.toSun), light.anisotropy, light.forwardShare);
    const double opacity = 1 - result.transmittance, rounding = 1e-12;
    EXPECT_TRUE(opacity >= 0 && opacity <= 1) << opacity;
    EXPECT_TRUE(result.sun >= 0 && result.sun <= opacity * f64::scatteredSun(phases, 0) + rounding)
        << result.sun;
    EXPECT_TRUE(result.sky >= 0 && result.sky <= opacity / (2 * std::numbers::pi) + rounding) << result.sky;
    EXPECT_TRUE(result.ground >= 0 && result.ground <= opacity / (2 * std::numbers::pi) + rounding)
        << result.ground;
    EXPECT_TRUE(result.distanceM == 1e30 ||
                (result.distanceM >= 0 && result.distanceM <= field.fadeDistance()))
        << result.distanceM;
  }
}

int expectSound(const CloudSettings& settings, core::RandomStream& random) {
  CloudField field(quickNoise(), settings);
  const glm::dvec2 drift = core::windDrift({}, 30.0 * 86400);
  field.setDrift(drift);
  expectSoundMarch(field, random);
  return expectSoundMedium(field, settings, drift, random);
}

TEST(CloudEdges, bothEndsOfEverySettingAreSound) {
  core::RandomStream random{1, 0};
  CloudSettings settings = cloudySettings();
  const core::SettingsTable table(settings);
  int rows = 0, clear = 0;
  for (const core::Field& field : table.fields()) {
    if (!isNumeric(field)) continue;
    for (const double end : {field.min, field.max}) {
      settings = cloudySettings();
      core::setField(field, end);
      clear += expectSound(settings, random) == 0;
      ASSERT_FALSE(HasFailure()) << field.path << " at " << end;
    }
    ++rows;
  }
  EXPECT_GE(rows, 20);
  EXPECT_LE(clear, 3) << "too many settings leave nothing to judge";
}

TEST(CloudEdges, corneredSettingsAreSound) {
  // Every numeric setting at an end of its range, drawn by chance: 200 corners of all there are.
  core::RandomStream random{2, 0};
  CloudSettings settings;
  const core::SettingsTable table(settings);
  int cloudy = 0;
  for (int corner = 0; corner < 200; ++corner) {
    for (const core::Field& field : table.fields()) {
      if (isNumeric(field)) core::setField(field, random.next() % 2 == 0 ? field.min : field.max);
    }
    cloudy += expectSound(settings, random) > 0;
    ASSERT_FALSE(HasFailure()) << "corner " << corner;
  }
  EXPECT_GT(cloudy, 20) << "proves little";
}

}  // namespace
}  // namespace skydrop::clouds
