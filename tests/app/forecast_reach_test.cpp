// What a forecast says arrives where it is drawn, heard and felt.
#include <gtest/gtest.h>

#include <cmath>

#include "render/clouds/weather_layers.h"
#include "skydrop/game/ice_layers.h"
#include "skydrop/game/world.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/weather/lightning.h"

namespace skydrop {
namespace {

using weather::Genus;
using weather::State;

constexpr std::int64_t kFirst = 1782000000000, kHour = 3600000;  // ms

// A storm in the first hour; in the second high cirrus in a fast wind.
std::shared_ptr<const weather::Forecast> stormThenCirrus() {
  std::vector<weather::TimedState> hours(2);
  for (std::size_t i = 0; i < 2; ++i) {
    hours[i].utcMs = kFirst + static_cast<std::int64_t>(i) * kHour;
    hours[i].state.wind.levels = {{{1500, 10, 90}, {5500, 20, 90}, {10000, 50, 90}}};
  }
  State &storm = hours[0].state, &cirrus = hours[1].state;
  storm.layers[0] = {Genus::cumulonimbus, 700, 9000, 0.7, 1};
  storm.lightningPerMinute = 20;
  cirrus.layers[2] = {Genus::cirrus, 9000, 10000, 0.5, 1};
  return std::make_shared<const weather::Forecast>(
      weather::Forecast{weather::Timeline(hours), weather::Timeline(hours), std::nullopt, 7});
}

// Sites made by hand that have no weather at all, which a forecast replaces.
weather::Moment momentAt(double hour) {
  auto settings = std::make_shared<weather::WeatherSettings>();
  settings->variability = 0;
  return {settings, 1, 0, stormThenCirrus(), {false, hour, 1}};
}

TEST(ForecastReach, itsLayersAreThoseThatAreDrawn) {
  const auto layersAt = [](double hour) { return render::WeatherLayers::mediaOf(momentAt(hour), {0, 0}); };
  const auto storm = layersAt(0), cirrus = layersAt(1);
  ASSERT_EQ(storm.size(), 1u) << "one of its layers is a volume at some hour";
  EXPECT_TRUE(storm[0].isThere);
  EXPECT_EQ(storm[0].cover, 0.7);
  EXPECT_NEAR(storm[0].medium.layer.cloudHeight, 700, 1e-3);
  ASSERT_EQ(cirrus.size(), 1u) << "as many at any moment";
  EXPECT_FALSE(cirrus[0].isThere);
  EXPECT_NEAR(layersAt(0.5)[0].cover, 0.35, 1e-12);
  weather::Moment byHand = momentAt(0);
  byHand.forecast = nullptr;
  EXPECT_TRUE(render::WeatherLayers::mediaOf(byHand, {0, 0}).empty());
  byHand.handover =
      std::make_shared<const weather::Handover>(weather::Handover{stormThenCirrus(), {false, 0, 1}, -30, 60});
  const auto going = render::WeatherLayers::mediaOf(byHand, {0, 0});
  ASSERT_EQ(going.size(), 1u) << "what goes is drawn until it has gone";
  EXPECT_NEAR(going[0].cover, 0.35, 1e-12);
}

TEST(ForecastReach, itsStormHasFlashes) {
  // 20 a minute within sight of a place: of ten minutes 150 or more, and none an hour later.
  const weather::LightningSettings settings;
  const auto flashesAt = [&](double hour) {
    return weather::flashesBetween(momentAt(hour), settings, 0, 600, {0, 0}).size();
  };
  EXPECT_GT(flashesAt(0), 100u);
  EXPECT_EQ(flashesAt(2), 0u);
  weather::Moment byHand = momentAt(0);
  byHand.forecast = nullptr;
  EXPECT_TRUE(weather::flashesBetween(byHand, settings, 0, 600, {0, 0}).empty());
}

TEST(ForecastReach, itsWindFormsTheStrandsOfItsIce) {
  const weather::Moment moment = momentAt(1);
  const auto ice = game::iceLayersAt(moment, {0, 0});
  ASSERT_EQ(ice.size(), 1u);
  EXPECT_EQ(ice[0].genus, clouds::IceGenus::cirrus);
  EXPECT_NEAR(std::abs(ice[0].along.x), 1, 1e-6) << "the wind is from east at every height";
  EXPECT_TRUE(game::iceLayersAt(momentAt(0), {0, 0}).empty());
  weather::Wind other = weather::strandWind(*moment.forecast);
  for (weather::WindLevel& level : other.levels) level.directionDeg = 0;
  auto turned = std::make_shared<weather::Forecast>(*moment.forecast);
  turned->strandWind = other;
  weather::Moment then = moment;
  then.forecast = turned;
  EXPECT_NEAR(std::abs(game::iceLayersAt(then, {0, 0})[0].along.y), 1, 1e-6);
}

TEST(ForecastReach, itsGustsAreFeltByPackages) {
  // A package falls from 400 m: where it lands depends on the share of the gusts that it feels, in a forecast
  // of a fresh wind; in one of a calm it does not.
  const auto landing = [](double windMps, double share) {
    std::vector<weather::TimedState> hours(1);
    hours[0].utcMs = kFirst;
    State& state = hours[0].state;
    state.wind.speedMps = windMps;
    state.wind.levels = {{{1500, windMps, 0}, {5500, windMps, 0}, {10000, windMps, 0}}};
    game::WorldSetup setup;
    setup.ground = terrain::makeFlatSource(0);
    setup.start.position = {0, 400, 0};
    weather::WeatherSettings settings;
    settings.variability = 0;
    settings.packageGusts = share;
    setup.weather =
        game::WeatherSetup{settings,
                           {},
                           nullptr,
                           std::make_shared<const weather::Forecast>(weather::Forecast{
                               weather::Timeline(hours), weather::Timeline(hours), std::nullopt, 1})};
    game::World world(setup);
    game::Controls drop;
    drop.drop = true;
    world.step(drop);
    glm::dvec3 last(0);
    for (int i = 0; i < 120 * 90; ++i) {
      world.step({});
      const auto& packages = world.now().packages;
      if (!packages.empty()) last = packages.front().position;
      if (packages.empty() && last != glm::dvec3(0)) break;
    }
    return last;
  };
  const glm::dvec3 calm = landing(0, 0), calmGusts = landing(0, 1), mean = landing(12, 0),
                   gusts = landing(12, 1);
  EXPECT_LT(glm::length(calm - calmGusts), 0.5);
  EXPECT_GT(mean.z - calm.z, 20) << "the mean wind of the forecast blows from north";
  EXPECT_GT(glm::length(gusts - mean), 1);
}

}  // namespace
}  // namespace skydrop
