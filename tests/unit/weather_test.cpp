// The state of the air: sites, their mixture, wind over height, draughts, ice.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "skydrop/flight/airplane.h"
#include "skydrop/flight/package.h"
#include "skydrop/weather/draughts.h"
#include "skydrop/weather/icing.h"
#include "skydrop/weather/standard_atmosphere.h"
#include "skydrop/weather/weather_settings.h"
#include "skydrop/weather/wind_profile.h"

namespace skydrop::weather {
namespace {

WeatherSettings twoSites() {
  WeatherSettings s;
  s.variability = 0;
  s.secondSite = true;
  s.sites[0].temperature = 20;
  s.sites[1].temperature = 10;
  s.sites[1].eastM = 10000;
  return s;
}

TEST(Weather, changesSmoothlyOnTheWayBetweenTwoSites) {
  // Near the first site its weather, near the second that one's, halfway the mean, everywhere beyond the
  // nearer one's.
  const WeatherSettings s = twoSites();
  const auto at = [&](double east, double south) { return stateAt(s, 1, 0, {east, south}).temperatureC; };
  EXPECT_EQ(at(0, 0), 20);
  EXPECT_EQ(at(-5000, 700), 20);
  EXPECT_EQ(at(10000, -300), 10);
  EXPECT_EQ(at(1e7, 0), 10);
  EXPECT_NEAR(at(5000, 12345), 15, 1e-9) << "across the way nothing changes";
  EXPECT_NEAR(at(1, 0), 20, 1e-5) << "the way begins level";
}

TEST(Weather, theSecondSitesWeatherComesNearerAsTimeGoesOn) {
  WeatherSettings s = twoSites();
  s.approachSeconds = 1000;
  const auto at = [&](double seconds) { return stateAt(s, 1, seconds, {0, 0}).temperatureC; };
  EXPECT_EQ(at(0), 20);
  EXPECT_NEAR(at(500), 15, 1e-9);
  EXPECT_EQ(at(1000), 10);
  EXPECT_EQ(at(1e6), 10);
}

TEST(Weather, aLayerThatChangesItsGenusGoesBeforeTheOtherComes) {
  State a, b;
  a.layers[0] = {Genus::cumulus, 1000, 2000, 0.8, 1};
  b.layers[0] = {Genus::stratus, 300, 600, 0.6, 1};
  EXPECT_NEAR(mixed(a, b, 0.25).layers[0].cover, 0.4, 1e-12);
  EXPECT_EQ(mixed(a, b, 0.25).layers[0].genus, Genus::cumulus);
  EXPECT_NEAR(mixed(a, b, 0.5).layers[0].cover, 0, 1e-12);
  EXPECT_NEAR(mixed(a, b, 0.75).layers[0].cover, 0.3, 1e-12);
  EXPECT_EQ(mixed(a, b, 0.75).layers[0].genus, Genus::stratus);
}

TEST(WindProfile, isLogarithmicNearTheGroundAndThatOfTheLevelsAbove) {
  // 10 m above the ground the speed measured there, from its direction; at a level that level's; between
  // halfway.
  Wind wind;
  wind.speedMps = 8;
  wind.directionDeg = 270;
  wind.levels = {{{1500, 20, 270}, {5500, 30, 0}, {10000, 40, 0}}};
  const WindProfile profile(wind);
  EXPECT_NEAR(profile.at(10, 10).x, 8, 1e-9) << "from west it blows to east";
  EXPECT_NEAR(profile.at(10, 10).z, 0, 1e-9);
  EXPECT_NEAR(profile.at(10, 10).x / profile.at(100, 100).x, std::log(10 / 0.05) / std::log(100 / 0.05),
              1e-3);
  EXPECT_EQ(profile.at(0, 0), glm::dvec3(0));
  EXPECT_NEAR(profile.at(1500, 1500).x, 20, 1e-9);
  EXPECT_NEAR(profile.at(5500, 5500).z, 30, 1e-9) << "from north it blows to south";
  EXPECT_NEAR(profile.at(3500, 3500).x, 10, 1e-9);
  EXPECT_NEAR(profile.at(3500, 3500).z, 15, 1e-9);
  EXPECT_NEAR(glm::length(profile.at(20000, 20000)), 40, 1e-9);
  EXPECT_NEAR(profile.w20Mps(), 8 * std::log(1 + 6.096 / 0.05) / std::log(1 + 10 / 0.05), 1e-9);
}

TEST(Draughts, airRisesUnderACumulusAndSinksBesideIt) {
  // Nothing at the ground, at the top and without cover; most at the base; beside the columns it sinks.
  const Layer layer{Genus::cumulus, 1500, 3300, 0.3, 1};
  EXPECT_EQ(cloudDraught(layer, 1, 0, 0, 0), 0);
  EXPECT_EQ(cloudDraught(layer, 1, 3300, 0, 0), 0);
  EXPECT_NEAR(cloudDraught(layer, 1, 1500, 0, 0), 2.5, 1e-9);
  EXPECT_NEAR(cloudDraught(layer, 1, 187.5, 0, 0), 1.25, 1e-9) << "the cube root of an eighth";
  EXPECT_LT(cloudDraught(layer, 0, 1000, 0, 0), 0);
  EXPECT_NEAR(0.3 * cloudDraught(layer, 1, 1500, 0, 0) + 0.7 * cloudDraught(layer, 0, 1500, 0, 0), 0, 1e-9)
      << "as much comes down as goes up";
  EXPECT_EQ(cloudDraught({Genus::cumulus, 1500, 3300, 0, 1}, 1, 1500, 0, 0), 0);
  EXPECT_EQ(cloudDraught({Genus::altostratus, 1500, 3300, 1, 1}, 1, 1500, 0, 0), 0);
}

TEST(Draughts, heavyRainTurnsACumulonimbusIntoADownburst) {
  const Layer storm{Genus::cumulonimbus, 1000, 11000, 0.4, 1};
  EXPECT_GT(cloudDraught(storm, 1, 3000, 0, 0), 9);
  EXPECT_LT(cloudDraught(storm, 1, 500, 0, 30), -6);
  EXPECT_EQ(cloudDraught(storm, 1, 0, 0, 30), 0);
}

TEST(Draughts, airRisesBeforeARidgeAndSinksInItsLee) {
  // Up where the wind meets the slope, down where it leaves it, level across it; half as strong 276 m above.
  const glm::dvec2 wind(10, 0);
  EXPECT_NEAR(slopeDraught(wind, {0.01, 0}, 0), 0.1, 1e-3);
  EXPECT_NEAR(slopeDraught(wind, {-0.01, 0}, 0), -0.1, 1e-3);
  EXPECT_EQ(slopeDraught(wind, {0, 0.3}, 0), 0);
  EXPECT_NEAR(slopeDraught(wind, {0.01, 0}, 275.8) / slopeDraught(wind, {0.01, 0}, 0), 0.5, 1e-3);
  EXPECT_LT(std::abs(slopeDraught({50, 0}, {8, 0}, 0)), 12) << "no wall throws the aircraft up";
  EXPECT_EQ(slopeDraught(wind, {0, 0}, 0), 0);
}

TEST(Icing, growsInColdCloudAndMeltsInWarmAir) {
  // Full within minutes at -7 degrees, none in warm cloud, in cold clear air or below -25; gone in a minute
  // at +10.
  EXPECT_GT(iceAfter(0, {-7, 1, 0}, 1, 90), 0.8);
  EXPECT_EQ(iceAfter(0, {5, 1, 0}, 1, 600), 0);
  EXPECT_EQ(iceAfter(0, {-7, 0, 0}, 1, 600), 0);
  EXPECT_EQ(iceAfter(0, {-30, 1, 0}, 1, 600), 0);
  EXPECT_GT(iceAfter(0, {-3, 0, 8}, 1, 120), 0.5) << "freezing rain";
  EXPECT_LT(iceAfter(1, {10, 1, 0}, 1, 60), 0.2);
  EXPECT_LT(iceAfter(1, {-10, 0, 0}, 1, 1800), 0.2);
  EXPECT_EQ(iceAfter(0.4, {-7, 1, 0}, 0, 60), iceAfter(0.4, {-7, 0, 0}, 1, 60)) << "a rate of 0 grows none";
  const double whole = iceAfter(0.2, {-5, 0.7, 0}, 1, 40);
  EXPECT_NEAR(iceAfter(iceAfter(0.2, {-5, 0.7, 0}, 1, 15), {-5, 0.7, 0}, 1, 25), whole, 1e-12);
}

flight::BodyState level(double speed, double height = 1000) {
  flight::BodyState state;
  state.position.y = height;
  state.velocity = {0, 0, -speed};
  return state;
}

TEST(FlightInThinAir, liftAndDragScaleWithDensity) {
  // The same indicated airspeed gives the same load factor: true airspeed over the root of the density's
  // share.
  flight::AirMass thin;
  thin.densityShare = standardAir(3000).densityKgM3 / kSeaLevelDensity;
  const double fast = 70 / std::sqrt(thin.densityShare);
  const flight::Airflow low = airflowOf({}, 0, flight::AirMass(), level(70));
  const flight::Airflow high = airflowOf({}, 0, thin, level(fast));
  EXPECT_NEAR(high.loadFactor, low.loadFactor, 1e-9);
  EXPECT_NEAR(high.airspeed / low.airspeed, 1.161, 0.001) << "IAS and TAS at 3 km";
  EXPECT_GT(airflowOf({}, 0, thin, level(40)).stallShare,
            airflowOf({}, 0, flight::AirMass(), level(40)).stallShare);
}

TEST(FlightWithIce, theWingCarriesLess) {
  // At full ice 30 % of the lift is gone: hands off the aircraft sinks, where clean it holds its height.
  const auto heightAfter20s = [](double ice) {
    flight::AirMass air;
    air.liftShare = 1 - kIceLiftLoss * ice;
    air.dragShare = 1 + kIceDragGain * ice;
    flight::Airplane airplane({}, level(70));
    for (int i = 0; i < 2400; ++i) airplane.step({}, air, 1.0 / 120);
    return airplane.body().position().y;
  };
  EXPECT_NEAR(heightAfter20s(0), 1000, 10);
  EXPECT_LT(heightAfter20s(1), 960);
}

TEST(LandingPrediction, takesTheWindOverHeightIntoAccount) {
  // In a wind that grows and turns with height the predicted place is within 2 m of the 120 Hz flight, from
  // 60 to 2000 m; a constant wind as a field gives that of the constant one within 1 cm.
  Wind wind;
  wind.speedMps = 9;
  wind.directionDeg = 300;
  wind.levels = {{{1000, 22, 340}, {3000, 30, 20}, {10000, 40, 30}}};
  const WindProfile profile(wind);
  const auto flat = [](const glm::dvec2&) { return 0.0; };
  for (const double height : {60.0, 200.0, 500.0, 2000.0}) {
    const flight::PointState release{{0, height, 0}, {70, 2, 10}};
    const auto predicted =
        predictLanding({}, release, flight::WindField([&](const glm::dvec3& at, double surface) {
                         return profile.at(at.y, at.y - surface);
                       }),
                       flat);
    ASSERT_TRUE(predicted);
    flight::BodyState body;
    body.position = release.position;
    body.velocity = release.velocity;
    flight::Package package({}, body);
    while (package.state().position.y > 0) {
      const glm::dvec3& at = package.state().position;
      package.step(profile.at(at.y, at.y), 1.0 / 120);
    }
    const glm::dvec3 miss = package.state().position - predicted->position;
    RecordProperty("missM", std::to_string(glm::length(glm::dvec2(miss.x, miss.z))));
    EXPECT_LT(glm::length(glm::dvec2(miss.x, miss.z)), 2) << height;
    const glm::dvec3 even(7, 0, -3);
    const auto constant = predictLanding({}, release, even, flat);
    const auto field =
        predictLanding({}, release, flight::WindField([&](const glm::dvec3&, double) { return even; }), flat);
    EXPECT_LT(glm::length(constant->position - field->position), 0.01) << height;
  }
}

}  // namespace
}  // namespace skydrop::weather
