#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "skydrop/core/hash.h"
#include "skydrop/core/shared.h"

namespace skydrop::core {
namespace {

namespace shared = skydrop::core::shared::f64;

double luminance(const glm::dvec3& albedo) { return glm::dot(albedo, glm::dvec3(0.2126, 0.7152, 0.0722)); }

// Land without noise, strata and trees near by.
shared::LandSurface plainLand(double heightM, double normalUp, double curvature = 0) {
  return shared::landSurface(heightM, normalUp, curvature, {0, 0, 0, 0, 0}, 0, {{0, 0}, 0, 0.5}, 0);
}

TEST(LandMaterial, alpineBeltsRiseWithHeightAndKeepTheShore) {
  double before = -1000;
  for (double height = -500; height < 9000; height += 7) {
    const double belt = shared::alpineBeltHeight(height);
    ASSERT_GT(belt, before) << height;
    before = belt;
  }
  EXPECT_EQ(shared::alpineBeltHeight(-20), -20);
  EXPECT_NEAR(shared::alpineBeltHeight(4), 4, 0.2) << "the beach ends at 4 m";
  EXPECT_NEAR(shared::alpineBeltHeight(2260), 780, 1) << "the last woods";
  EXPECT_NEAR(shared::alpineBeltHeight(2800), 960, 1) << "the first snow";
}

TEST(LandMaterial, noiseInSpaceIsSmoothAndHasTheSlopeThatItTells) {
  // 100 000 places on either side of the lattice's corner: mean 0 within 0.01, standard deviation between 0.2
  // and 0.4, all within [-1.2, 1.2]; slopes are those of differences over 2e-5 cells within 1e-4 per cell
  // (rounding of the difference: 1e-11).
  RandomStream random{11, 0};
  const glm::u32vec3 corner(4000000000u, 17u, 5u);
  double sum = 0, squares = 0;
  for (int i = 0; i < 100000; ++i) {
    const glm::dvec3 at = (glm::dvec3(random.nextUnit(), random.nextUnit(), random.nextUnit()) - 0.5) * 400.0;
    const glm::dvec4 noise = shared::simplexNoise(corner, at);
    sum += noise.w;
    squares += noise.w * noise.w;
    ASSERT_LE(std::abs(noise.w), 1.2);
    if (i % 100 != 0) continue;
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 step(0);
      step[axis] = 1e-5;
      const double slope =
          (shared::simplexNoise(corner, at + step).w - shared::simplexNoise(corner, at - step).w) / 2e-5;
      ASSERT_NEAR(noise[axis], slope, 1e-4);
    }
  }
  EXPECT_NEAR(sum / 1e5, 0, 0.01);
  const double deviation = std::sqrt(squares / 1e5);
  EXPECT_GT(deviation, 0.2);
  EXPECT_LT(deviation, 0.4);
}

TEST(LandMaterial, chunkCornersAreCornersOfTheSkewedLattice) {
  // A place told from two bases, 720 cells apart along x, has the same noise: what land far out and a base
  // that moves with the eye rely on. 1e-9: rounding of the position.
  const glm::u32vec3 here(240u, 240u, 240u), there(960u + 240u, 480u, 480u);
  const glm::u32vec3 origin(0u, 0u, 0u), east(960u, 240u, 240u);
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 at(0.37 * i, 0.11 * i, 0.73 * i);
    const glm::dvec4 a = shared::simplexNoise(origin, at + glm::dvec3(720, 0, 0));
    const glm::dvec4 b = shared::simplexNoise(east, at);
    ASSERT_NEAR(a.w, b.w, 1e-9) << i;
    ASSERT_NEAR(shared::simplexNoise(here, at + glm::dvec3(720, 0, 0)).w, shared::simplexNoise(there, at).w,
                1e-9);
  }
}

TEST(LandMaterial, albedosAreThoseOfRealSurfaces) {
  // Whatever the noise, light that is sent back is between that of wet moss and of fresh snow, and the shares
  // stay shares.
  RandomStream random{12, 0};
  const auto signedUnit = [&] { return 2 * random.nextUnit() - 1; };
  for (int i = 0; i < 100000; ++i) {
    const shared::LandNoise noise{signedUnit(), signedUnit(), signedUnit(), signedUnit(), signedUnit()};
    const shared::LandSurface land = shared::landSurface(
        -100 + 2500 * random.nextUnit(), random.nextUnit(), signedUnit(), noise, signedUnit(),
        {{signedUnit(), signedUnit()}, 2 * signedUnit(), random.nextUnit()}, random.nextUnit());
    for (int c = 0; c < 3; ++c) {
      ASSERT_GT(land.albedo[c], 0.001);
      ASSERT_LT(land.albedo[c], 0.92);
    }
    for (const double share : {land.roughness, land.wooded, land.open}) {
      ASSERT_GE(share, 0);
      ASSERT_LE(share, 1);
    }
  }
}

TEST(LandMaterial, snowLiesHighAndNotOnCliffs) {
  // White above the line on level ground, rock on cliffs, and a hollow keeps its snow lower than a ridge.
  EXPECT_GT(luminance(plainLand(1300, 0.98).albedo), 0.7);
  EXPECT_LT(luminance(plainLand(1300, 0.45).albedo), 0.25);
  EXPECT_LT(luminance(plainLand(500, 0.98).albedo), 0.2);
  EXPECT_GT(luminance(plainLand(930, 0.98, -0.2).albedo), 2 * luminance(plainLand(930, 0.98, 0.2).albedo));
}

TEST(LandMaterial, hollowsAreGreenerAndDarkerThanRidges) {
  // Green against red, and the share of the sky that a hollow sees.
  const shared::LandSurface hollow = plainLand(200, 0.97, -0.2), ridge = plainLand(200, 0.97, 0.2);
  EXPECT_GT(hollow.albedo.y / hollow.albedo.x, 1.1 * ridge.albedo.y / ridge.albedo.x);
  EXPECT_LT(hollow.open, 0.8);
  EXPECT_EQ(ridge.open, 1);
}

TEST(LandMaterial, theBeachIsDarkWhereItIsWet) {
  // Sand at 2 m is brighter than at the water's edge, and both are brighter than grass.
  EXPECT_GT(luminance(plainLand(1.7, 0.99).albedo), 1.5 * luminance(plainLand(0.1, 0.99).albedo));
  EXPECT_GT(luminance(plainLand(1.7, 0.99).albedo), 2 * luminance(plainLand(30, 0.99).albedo));
}

TEST(LandMaterial, strataFadeWherePixelsCannotShowThem) {
  // The layers' waves have both signs near by; a pixel of 20 m shows none of them.
  double lowest = 1, highest = -1;
  for (double h = 0; h < 200; h += 0.5) {
    const double layer = shared::rockStrata(h, 0, 0.1).x;
    lowest = std::min(lowest, layer);
    highest = std::max(highest, layer);
    ASSERT_EQ(shared::rockStrata(h, 0, 20).x, 0) << h;
  }
  EXPECT_LT(lowest, -0.6);
  EXPECT_GT(highest, 0.6);
}

TEST(LandMaterial, woodsStandWhereTreesGrow) {
  // On gentle ground between the shore and the tree line, in patches, and rather in hollows than on ridges.
  const shared::LandNoise wooded{0.8, 0, 0, 0, 0}, open{-0.6, 0, 0, 0, 0}, between{0.2, 0, 0, 0, 0};
  EXPECT_EQ(shared::forestDensity(200, 0.95, 0, wooded), 1);
  EXPECT_EQ(shared::forestDensity(200, 0.95, 0, open), 0);
  EXPECT_EQ(shared::forestDensity(2, 0.95, 0, wooded), 0) << "the shore";
  EXPECT_EQ(shared::forestDensity(800, 0.95, 0, wooded), 0) << "above the tree line";
  const double thin = shared::forestDensity(660, 0.95, 0, wooded);
  EXPECT_TRUE(thin > 0.4 && thin < 0.6) << thin;
  EXPECT_EQ(shared::forestDensity(200, 0.69, 0, wooded), 0) << "46 degrees";
  const double level = shared::forestDensity(200, 0.95, 0, between);
  EXPECT_GT(shared::forestDensity(200, 0.95, -0.2, between), level) << "a hollow";
  EXPECT_LT(shared::forestDensity(200, 0.95, 0.2, between), level) << "a ridge";
}

TEST(LandMaterial, woodsAreDrawnWhereTheirDensitySaysSo) {
  // Where no cliff, beach or snow hides them, the land far away is wooded by that density exactly, so that
  // trees that are planted by it meet the woods that are painted.
  RandomStream random{13, 0};
  const auto signedUnit = [&] { return 2 * random.nextUnit() - 1; };
  int partly = 0;
  for (int i = 0; i < 10000; ++i) {
    const shared::LandNoise noise{signedUnit(), signedUnit(), signedUnit(), signedUnit(), signedUnit()};
    const double height = 20 + 480 * random.nextUnit(), normalUp = 0.94 + 0.06 * random.nextUnit();
    const double curvature = 0.5 * signedUnit();
    const double density = shared::forestDensity(height, normalUp, curvature, noise);
    const shared::LandSurface land =
        shared::landSurface(height, normalUp, curvature, noise, 0, {{0, 0}, 0, 0.5}, 0);
    ASSERT_EQ(land.wooded, density);
    partly += density > 0.01 && density < 0.99;
  }
  EXPECT_GT(partly, 1000);
}

TEST(LandMaterial, theEveningHorizonKeepsSomeBlue) {
  // With the sun at 1 degree the light of the horizon is warm, but air lit by the sky overhead keeps its blue
  // above a twentieth of its red: with the sun's own light alone it has a fiftieth, and dusk is plain yellow.
  shared::Atmosphere air{};
  air.rayleigh = {5.802e-6, 13.558e-6, 33.1e-6};
  air.rayleighHeight = 8000;
  air.haze = 2.56e-5;
  air.hazeHeight = 1200;
  air.hazeAlbedo = 0.94;
  air.hazeAnisotropy = 0.7;
  const shared::SkyColumn column = shared::make_skyColumn(air, 300, std::sin(0.01745));
  const glm::dvec3 horizon = shared::skyRadiance(shared::skySource(column, air, 0), 0, 0.7);
  const glm::dvec3 zenith = shared::skyRadiance(shared::skySource(column, air, 1), 0, 0.7);
  EXPECT_GT(horizon.x, horizon.z);
  EXPECT_GT(horizon.z, horizon.x / 20);
  EXPECT_GT(zenith.z, zenith.x);
}

}  // namespace
}  // namespace skydrop::core
