// What falls out of clouds, and what it is made of: against the distributions and speeds of the literature.
#include "skydrop/weather/fall.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "skydrop/core/shared_precipitation.h"
#include "skydrop/render/precipitation/drop_sets.h"
#include "skydrop/render/precipitation/wet_ground_pass.h"

namespace skydrop::weather {
namespace {

namespace shared = core::shared::f64;

State rainy(Genus genus, double rain, double temperatureC = 15) {
  State state;
  state.layers[1] = {.genus = genus, .baseM = 1500, .topM = 4000, .cover = 0.6};
  state.precipitation.rain = rain;
  state.temperatureC = temperatureC;
  return state;
}

// Twice the cross section of an exponential distribution of diameters, by quadrature; mm and m^3.
double quadrature(double number, double slope, double widening) {
  double sum = 0;
  constexpr double kStep = 1e-3;
  for (double d = 0.5 * kStep; d < 60 / slope; d += kStep)
    sum += number * std::exp(-slope * d) * std::numbers::pi / 2 * d * d * kStep;
  return sum * widening * widening * 1e-6;
}

TEST(Fall, extinctionIsTheCrossSectionOfTheDropsThatTheLiteratureCounts) {
  // Within 1e-4 of the integral over Marshall and Palmer's and Gunn and Marshall's distributions.
  for (const double rate : {0.1, 1.0, 10.0, 150.0}) {
    const double rain = quadrature(shared::kRainDrops, shared::rainSlope(rate), 1);
    EXPECT_NEAR(shared::rainExtinction(rate) / rain, 1, 1e-4) << rate;
    const double flakes =
        quadrature(3800 * std::pow(rate, -0.87), shared::snowSlope(rate), shared::kFlakeWidening);
    EXPECT_NEAR(shared::snowExtinction(rate) / flakes, 1, 1e-4) << rate;
  }
  EXPECT_EQ(shared::rainExtinction(0), 0);
  EXPECT_EQ(shared::snowExtinction(0), 0);
}

TEST(Fall, sightIsThatOfRainAndSnow) {
  // Atlas (1953): 3.4e-4 R^0.63, within 8 %; a millimetre an hour of snow ends sight at about a kilometre.
  for (const double rate : {1.0, 10.0, 50.0})
    EXPECT_NEAR(shared::rainExtinction(rate) / (3.4e-4 * std::pow(rate, 0.63)), 1, 0.08);
  EXPECT_NEAR(3.912 / shared::snowExtinction(1), 1200, 200);
}

TEST(Fall, classesHoldAllOfTheExtinctionAndFallAsFastAsTheirKind) {
  // Rain from 4 to 9 m/s but for the smallest third in light rain, snow about 1, pellets between, hail above.
  for (const double rate : {0.5, 5.0, 50.0, 150.0}) {
    const auto classes = render::fallClasses({.rain = rate, .snow = rate});
    ASSERT_EQ(classes.size(), 5u);
    double rain = 0, snow = 0;
    for (const render::FallClass& one : classes) {
      (one.kind == render::FallKind::rain ? rain : snow) += one.extinction;
      if (one.kind == render::FallKind::snow) {
        EXPECT_NEAR(one.speedMps, 1, 0.25);
      }
    }
    EXPECT_NEAR(rain / shared::rainExtinction(rate), 1, 1e-9);
    EXPECT_NEAR(snow / shared::snowExtinction(rate), 1, 1e-9);
    EXPECT_GT(classes[1].speedMps, rate < 1 ? 3 : 4);
    EXPECT_GT(classes[2].speedMps, classes[1].speedMps);
    EXPECT_LT(classes[2].speedMps, 9.65);
  }
  const auto ice = render::fallClasses({.sleet = 2, .hail = 3});
  ASSERT_EQ(ice.size(), 2u);
  EXPECT_NEAR(ice[0].speedMps, 5, 1);
  EXPECT_GT(ice[1].speedMps, 10);
  EXPECT_TRUE(render::fallClasses({}).empty());
}

TEST(Fall, thirdsOfTheWaterHaveTheMeanSizesAndSectionsOfTheirParts) {
  // The constants of the three classes of rain, against quadrature: thirds of the integral of D^3 exp(-D).
  constexpr double kStep = 1e-4;
  double water = 0, all = 0, section = 0;
  for (double d = 0.5 * kStep; d < 60; d += kStep) {
    all += d * d * d * std::exp(-d) * kStep;
    section += d * d * std::exp(-d) * kStep;
  }
  std::array<double, 3> weighted{}, parts{};
  for (double d = 0.5 * kStep; d < 60; d += kStep) {
    const double w = d * d * d * std::exp(-d) * kStep;
    const auto third = static_cast<std::size_t>(std::min(3 * water / all, 2.999));
    water += w;
    weighted[third] += d * w;
    parts[third] += d * d * std::exp(-d) * kStep;
  }
  const auto classes = render::fallClasses({.rain = 5});
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(classes[i].diameterMm * shared::rainSlope(5), weighted[i] / (all / 3), 0.02) << i;
    EXPECT_NEAR(classes[i].extinction / shared::rainExtinction(5), parts[i] / section, 0.01) << i;
  }
}

TEST(Fall, nothingFallsFromADrySkyNorAboveTheCloud) {
  State state = rainy(Genus::cumulonimbus, 10);
  EXPECT_GT(rateOf(fallAt(state, 0)), 0);
  EXPECT_EQ(rateOf(fallAt(state, 4000)), 0);
  EXPECT_EQ(rateOf(fallAt(state, 9000)), 0);
  EXPECT_LT(rateOf(fallAt(state, 3999)), 0.02);
  EXPECT_EQ(rateOf(fallAt(state, 0, 0)), 0) << "between the clouds";
  state.precipitation = {};
  EXPECT_EQ(rateOf(fallAt(state, 0)), 0);
  state = rainy(Genus::cirrus, 10);
  EXPECT_EQ(feedingLayer(state), nullptr);
  EXPECT_EQ(rateOf(fallAt(state, 0)), 0) << "cirrus feeds nothing";
  state = rainy(Genus::cumulus, 10);
  state.layers[1].cover = 0;
  EXPECT_EQ(rateOf(fallAt(state, 0)), 0);
}

TEST(Fall, theGroundGetsWhatTheStateSaysAndLightRainEndsOnTheWay) {
  // More at the base than on the ground; the edge of a shower is virga; drier and warmer air takes more.
  const State state = rainy(Genus::cumulus, 2);
  EXPECT_NEAR(fallAt(state, 0).rain, 2, 1e-9);
  EXPECT_GT(fallAt(state, 1499).rain, 2.5);
  double above = 1e9;
  for (double height = 1500; height >= 0; height -= 50) {
    const double rate = rateOf(fallAt(state, height));
    EXPECT_LE(rate, above);
    above = rate;
  }
  EXPECT_GT(rateOf(fallAt(state, 1400, 0.3)), 0.3);
  EXPECT_EQ(rateOf(fallAt(state, 0, 0.3)), 0);
  State desert = rainy(Genus::cumulus, 2, 35);
  desert.layers[1].baseM = 3500;
  EXPECT_GT(fallField(desert)->evaporation, 4 * fallField(state)->evaporation);
}

TEST(Fall, rainIsSnowWhereItFreezes) {
  const State state = rainy(Genus::nimbostratus, 4, 6.5);  // 0 degrees at 1000 m
  EXPECT_EQ(fallAt(state, 500).snow, 0);
  EXPECT_NEAR(fallAt(state, 1000).snow / rateOf(fallAt(state, 1000)), 0.5, 1e-9);
  EXPECT_EQ(fallAt(state, 1400).rain, 0);
  EXPECT_GT(fallAt(state, 1400).snow, 4);
}

TEST(Fall, cumuliRainInShowersAndNimbostratusEverywhere) {
  EXPECT_FALSE(fallsEverywhere({.genus = Genus::cumulus, .cover = 0.6}));
  EXPECT_FALSE(fallsEverywhere({.genus = Genus::cumulonimbus, .cover = 0.6}));
  EXPECT_TRUE(fallsEverywhere({.genus = Genus::cumulonimbus, .cover = 1}));
  EXPECT_TRUE(fallsEverywhere({.genus = Genus::nimbostratus, .cover = 0.6}));
  EXPECT_EQ(shared::rainShareOfMap(0.1, 1, 0.5), 0) << "no cloud";
  EXPECT_EQ(shared::rainShareOfMap(1, 0, 0.5), 0) << "a cloud without rain";
  EXPECT_EQ(shared::rainShareOfMap(1, 1, 0.5), 1);
}

TEST(Fall, rainDarkensLandAndSnowWhitensItFromItsLineOn) {
  // Angstrom's formula: 0.2 becomes 0.124; white stays white.
  EXPECT_NEAR(shared::wetAlbedo(0.2), 0.124, 0.001);
  EXPECT_EQ(shared::wetAlbedo(1), 1);
  EXPECT_EQ(shared::wetAlbedo(0), 0);
  const State state = rainy(Genus::nimbostratus, 4, 7);
  const render::FallenWater fallen = render::fallenWater(state, {0.5, 0.25});
  EXPECT_EQ(fallen.wet, 0.5);
  EXPECT_EQ(fallen.snow, 0.25);
  EXPECT_NEAR(fallen.snowLineM, 1000, 1);
  EXPECT_EQ(shared::fallenSnow(1, 800, 1000, 1, 0), 0);
  EXPECT_EQ(shared::fallenSnow(1, 1200, 1000, 1, 0), 1);
  EXPECT_EQ(shared::fallenSnow(1, 1200, 1000, 0.4, 0), 0) << "it slides from cliffs";
}

}  // namespace
}  // namespace skydrop::weather
