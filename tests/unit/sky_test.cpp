#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "skydrop/sky/atmosphere.h"

namespace skydrop::sky {
namespace {

constexpr double kHazeHeightM = 1200, kAnisotropy = 0.7;

SkyLight lightAt(double elevationDegrees, double heightM = 0, double visibilityM = 100000,
                 SkyModel model = SkyModel::closedForm) {
  return skyLight(makeAtmosphere(visibilityM, kHazeHeightM, kAnisotropy),
                  directionToSun(elevationDegrees, 135), heightM, model);
}

TEST(Sky, visibilityIsTheDistanceAtWhichContrastFallsToTwoPercent) {
  // Koschmieder, at sea level, for green; air without aerosol sees no farther than its molecules let it.
  for (const double visibilityM : {5000.0, 30000.0, 200000.0}) {
    const Atmosphere air = makeAtmosphere(visibilityM, kHazeHeightM, kAnisotropy);
    EXPECT_NEAR(transmittance(air, 0, 0, visibilityM).y, 0.02, 1e-4) << visibilityM;
  }
  EXPECT_EQ(makeAtmosphere(1e7, kHazeHeightM, kAnisotropy).haze, 0);
}

TEST(Sky, transmittanceIsTheExponentialOfTheOpticalDepth) {
  const Atmosphere air = makeAtmosphere(50000, kHazeHeightM, kAnisotropy);
  const glm::dvec3 depth = opticalDepth(air, 100, 2500, 9000), left = transmittance(air, 100, 2500, 9000);
  for (int c = 0; c < 3; ++c) EXPECT_EQ(left[c], std::exp(-depth[c]));
}

TEST(Sky, airTakesOfALightAndAddsThatOfTheHorizon) {
  // At no distance a light is as it is. Far away its own share is what the path lets through, and all that is
  // taken is made up by the horizon's light: a surface as bright as that is seen unchanged from anywhere on
  // its level.
  const SkyLight light = lightAt(30, 500);
  const glm::dvec3 own(3, 2, 1), place = glm::normalize(glm::dvec3(2, 0, -1)) * 8000.0;
  EXPECT_EQ(applyAerialPerspective(light, own, 500, glm::dvec3(0)), own);
  const glm::dvec3 black = applyAerialPerspective(light, glm::dvec3(0), 500, place);
  const glm::dvec3 lit = applyAerialPerspective(light, own, 500, place);
  const glm::dvec3 horizon = airRadiance(light, place / 8000.0, 8000);
  const glm::dvec3 unchanged = applyAerialPerspective(light, horizon, 500, place);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR((lit - black)[c], own[c] * transmittance(light.air, 500, 500, 8000)[c], 1e-12);
    EXPECT_NEAR(unchanged[c] / horizon[c], 1, 1e-12);
  }
}

TEST(Sky, noonIsAsBrightAsMeasured) {
  // With the sun at 60 degrees and clean air: 90 to 120 klx on a surface that faces it, 3 to 20 klx from the
  // sky (CIE: about a tenth of the total), and average land sends 12 % of what falls on it back.
  const SkyLight light = lightAt(60);
  EXPECT_TRUE(light.sun.y > 90 && light.sun.y < 120) << light.sun.y;
  EXPECT_TRUE(light.sky.y > 3 && light.sky.y < 20) << light.sky.y;
  EXPECT_NEAR(light.ground.y, 0.12 * (light.sun.y * light.toSun.y + light.sky.y), 1e-12);
  EXPECT_GT(lightAt(60, 3000).sun.z, light.sun.z) << "less air above a mountain";
}

TEST(Sky, theSunsDiscSetsOverItsOwnDiameter) {
  // One radius for the disc that is drawn and for its setting: all of it above the horizon one radius up,
  // half of it (of the illuminance without a horizon) on the horizon, nothing one radius down.
  const auto shareAt = [](double sine) { return core::shared::f64::sunVisibleShare(sine); };
  EXPECT_EQ(shareAt(kSunRadiusRad), 1);
  EXPECT_LT(shareAt(0.998 * kSunRadiusRad), 1);
  EXPECT_DOUBLE_EQ(shareAt(0), 0.5);
  EXPECT_GT(shareAt(-0.998 * kSunRadiusRad), 0);
  EXPECT_EQ(shareAt(-kSunRadiusRad), 0);
  EXPECT_EQ(lightAt(-1).sun, glm::dvec3(0));
  EXPECT_GT(lightAt(-1).sky.y, 0) << "twilight";
}

TEST(Sky, theDiscsRadianceGivesTheSunsIlluminance) {
  const SkyLight light = lightAt(30);
  const double solidAngle = std::numbers::pi * kSunRadiusRad * kSunRadiusRad;
  EXPECT_NEAR(sunDiscRadiance(light).y * solidAngle / light.sun.y, 1, 1e-12);
}

TEST(Sky, theHorizonIsWhereTheSkyMeetsIt) {
  // Haze sends what the sky sends from its lowest direction; directions below the horizon see the same.
  const SkyLight light = lightAt(20, 500);
  for (const double azimuth : {0.0, 1.0, 2.5}) {
    const glm::dvec3 level(std::sin(azimuth), 0, -std::cos(azimuth));
    const glm::dvec3 sky = skyRadiance(light, level);
    const glm::dvec3 haze = airRadiance(light, level, 0);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(sky[c] / haze[c], 1, 1e-12);
  }
}

TEST(Sky, theMeanHorizonIsTheMeanOverAllDirections) {
  // The phase functions integrate to 1 over the sphere: midpoints in the cosine of the angle to the sun.
  const SkyLight light = lightAt(20, 500);
  constexpr int kSteps = 20000;
  glm::dvec3 sum(0);
  for (int i = 0; i < kSteps; ++i) {
    const double cosine = -1 + 2 * (i + 0.5) / kSteps, sine = std::sqrt(1 - cosine * cosine);
    const glm::dvec3 aside = glm::normalize(glm::cross(light.toSun, glm::dvec3(0, 1, 0)));
    sum += airRadiance(light, light.toSun * cosine + aside * sine, 0) - light.night;
  }
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c] / kSteps / meanHorizonRadiance(light)[c], 1, 1e-5);
}

TEST(Sky, nightIsTheNightSkyAlone) {
  const SkyLight light = lightAt(-40);
  const glm::dvec3 zenith = skyRadiance(light, {0, 1, 0});
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(zenith[c] / light.night[c], 1, 1e-3);
}

}  // namespace
}  // namespace skydrop::sky
