// The air that the aircraft meets between two samples, against the air asked at every step.
#include "game/flown_air.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

#include "skydrop/game/contact.h"
#include "skydrop/terrain/noise_height_source.h"
#include "skydrop/weather/draughts.h"
#include "skydrop/weather/standard_atmosphere.h"

namespace skydrop::game {
namespace {

TEST(FlownAir, isThatOfEveryStepWithinSomeCentimetresASecond) {
  // Two minutes straight ahead, 150 m above hills, in a wind that turns and grows on the way: mixed between
  // four samples a second the wind is off by less than .03 m/s level and .01 upwards, the density by less
  // than 1e-4 (root mean squares).
  WorldSetup setup;
  setup.ground = terrain::makeNoiseHeightSource({}, 1);
  weather::WeatherSettings settings;
  settings.turbulence = settings.draughts = 0;
  settings.secondSite = true;
  settings.sites[0].windSpeed = 8;
  settings.sites[1].windSpeed = 14;
  settings.sites[1].windDirection = 330;
  settings.sites[1].eastM = 9000;
  setup.weather = {settings, core::WindSettings(), nullptr};
  FlownAir air(setup);
  flight::BodyState craft;
  craft.velocity = {70, 0, 0};
  craft.position = {0, surfaceAt(*setup.ground, {0, 0}).height + 150, 0};
  air.meet(craft.position, craft.position.y - 150, 0);
  double level = 0, upwards = 0, density = 0;
  constexpr int kSteps = 14400;
  double groundBefore = craft.position.y - 150;
  for (std::uint64_t step = 1; step <= kSteps; ++step) {
    const double ground = surfaceAt(*setup.ground, {craft.position.x, craft.position.z}).height;
    craft.position.y += ground - groundBefore;
    craft.velocity.y = (ground - groundBefore) * 120;
    groundBefore = ground;
    air.advance(craft, craft.position.y - ground, step);
    craft.position.x += craft.velocity.x / 120;
    const glm::dvec2 here(craft.position.x, craft.position.z);
    const double surface = surfaceAt(*setup.ground, here).height;
    const double above = craft.position.y - surface, seconds = static_cast<double>(step) / 120;
    const weather::State state = weather::stateAt(settings, setup.seed, seconds, here);
    const glm::dvec3 wind = weather::WindProfile(state.wind).at(craft.position.y, above);
    const glm::dvec2 along = glm::normalize(glm::dvec2(wind.x, wind.z));
    const double rise = (surfaceAt(*setup.ground, here + along * 150.0).height -
                         surfaceAt(*setup.ground, here - along * 150.0).height) /
                        300;
    const double up = weather::slopeDraught({wind.x, wind.z}, along * rise, above);
    const glm::dvec3 error = air.now().wind - glm::dvec3(wind.x, up, wind.z);
    level += (error.x * error.x + error.z * error.z) / kSteps;
    upwards += error.y * error.y / kSteps;
    const double share =
        weather::airAt(craft.position.y, state.temperatureC, state.pressurePa).densityKgM3 / 1.225;
    density += (air.now().densityShare - share) * (air.now().densityShare - share) / kSteps;
  }
  std::printf("rms error: level %.4f m/s, upwards %.4f m/s, density %.2e\n", std::sqrt(level),
              std::sqrt(upwards), std::sqrt(density));
  EXPECT_LT(std::sqrt(level), 0.03);
  EXPECT_LT(std::sqrt(upwards), 0.01);
  EXPECT_LT(std::sqrt(density), 1e-4);
}

TEST(FlownAir, iceGrowsInFreezingRainAndTakesLift) {
  // Two minutes in freezing rain at -5 degrees: ice, less lift and more drag; placed again it is gone.
  WorldSetup setup;
  setup.ground = terrain::makeNoiseHeightSource({}, 1);
  weather::WeatherSettings settings;
  for (auto& site : settings.sites) site.temperature = -3, site.rain = 5;
  setup.weather = {settings, core::WindSettings(), nullptr};
  FlownAir air(setup);
  flight::BodyState craft;
  craft.position = {0, 600, 0};
  craft.velocity = {70, 0, 0};
  air.meet(craft.position, 100, 0);
  for (std::uint64_t step = 1; step <= 14400; ++step) air.advance(craft, 500, step);
  EXPECT_GT(air.snapshot(craft).icing, 0.5);
  EXPECT_LT(air.now().liftShare, 0.9);
  EXPECT_GT(air.now().dragShare, 1.2);
  air.meet(craft.position, 100, 14400);
  EXPECT_EQ(air.snapshot(craft).icing, 0);
  EXPECT_EQ(air.now().liftShare, 1);
}

}  // namespace
}  // namespace skydrop::game
