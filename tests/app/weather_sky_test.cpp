// Skies of the weather: what they set, and what comes before and after them.
#include "app/settings/weather_sky.h"

#include <gtest/gtest.h>

#include <string>

#include "app/session/run_config.h"

namespace skydrop::app {
namespace {

using weather::SkyChoice;

CommandLine headless(const std::string& scene, std::vector<std::string> set) {
  CommandLine line;
  line.verb = Verb::render;
  line.scene = scene;
  line.set = std::move(set);
  return line;
}

TEST(WeatherSky, isTheWeatherOfItsSceneInAnyOther) {
  // Wind, sites and low clouds are those of the thunderstorm's scene, and none of a sky before it stays.
  const auto scene = prepareRun(headless("thunderstorm", {}));
  for (const char* other : {"breeze", "warmFront", "afterRain"}) {
    const auto run = prepareRun(headless(other, {"weather.sky=thunderstorm"}));
    for (const std::string& path : weatherSkyPaths(run->table))
      EXPECT_EQ(run->table.at(path).get(), scene->table.at(path).get()) << other << ' ' << path;
    EXPECT_EQ(run->settings.weather.sky, SkyChoice::thunderstorm);
  }
}

TEST(WeatherSky, eachIsWhatItsNameSays) {
  const auto of = [](SkyChoice sky) {
    Settings settings;
    applyWeatherSky(core::SettingsTable(settings), sky);
    weather::requireUsable(settings.weather);
    return settings;
  };
  EXPECT_EQ(of(SkyChoice::none).weather.sites[0].windSpeed, Settings().weather.sites[0].windSpeed);
  EXPECT_EQ(of(SkyChoice::fair).weather.sites[0].rain, 0);
  EXPECT_TRUE(of(SkyChoice::beforeWarmFront).weather.secondSite);
  EXPECT_GT(of(SkyChoice::frontPassing).weather.approachSeconds, 0);
  EXPECT_GT(of(SkyChoice::thunderstorm).weather.sites[0].lightning, 0);
  EXPECT_EQ(of(SkyChoice::thunderstorm).weather.sites[0].layers[0].genus, weather::Genus::cumulonimbus);
  EXPECT_EQ(of(SkyChoice::afterRain).weather.sites[0].lightning, 0);
}

TEST(WeatherSky, whatIsSetAfterItWinsAndItLeavesTheFeltShareAlone) {
  // A row of --set, whatever its place in the line; how strongly turbulence is felt stays the player's.
  const auto run = prepareRun(
      headless("breeze", {"weather.sites.0.rain=3", "weather.turbulence=0.5", "weather.sky=thunderstorm"}));
  EXPECT_EQ(run->settings.weather.sites[0].rain, 3);
  EXPECT_EQ(run->settings.weather.turbulence, 0.5);
  EXPECT_GT(run->settings.weather.sites[0].hail, 0);
}

}  // namespace
}  // namespace skydrop::app
