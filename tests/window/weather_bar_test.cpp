// The weather bar and the renewal of a forecast in the real window.
#include <gtest/gtest.h>

#include "support/paths.h"
#include "support/weather_server.h"
#include "window/flown_game.h"

namespace skydrop::test {
namespace {

using nlohmann::json;

constexpr double kHourMs = 3.6e6;

json weatherOf(const json& statistics) { return statistics.at("window").at("weather"); }

TEST(WeatherBarWindow, itsKeysShowItMoveTheHourChangeThePaceAndChooseLiveOrPlay) {
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown({"--scene", "terrain", "--weather",
                   sourceDir() + "/tests/corpus/weather/goodMeteoblue.json", "--set", "weatherFile.hour=4",
                   "--set", "weatherFile.pace=0"});
  const json at = weatherOf(flown.statistics());
  EXPECT_EQ(at.at("bar"), false);
  EXPECT_EQ(at.at("mode"), "live");
  const double begin = at.at("utcMs").get<double>();
  const auto hourIs = [&](double hours) {
    return [=](const json& s) {
      return std::abs(weatherOf(s).at("utcMs").get<double>() - begin - hours * kHourMs) < 1;
    };
  };
  flown.press("b");
  EXPECT_TRUE(flown.waitFor([](const json& s) { return weatherOf(s).at("bar") == true; }));
  flown.press("period");
  EXPECT_TRUE(flown.waitFor(hourIs(1)));
  flown.press("period");
  EXPECT_TRUE(flown.waitFor(hourIs(2)));
  flown.press("comma");
  EXPECT_TRUE(flown.waitFor(hourIs(1)));
  flown.press("bracketright");
  EXPECT_TRUE(flown.waitFor([](const json& s) { return weatherOf(s).at("pace") == 1; }));
  flown.press("bracketright");
  EXPECT_TRUE(flown.waitFor([](const json& s) { return weatherOf(s).at("pace") == 60; }));
  flown.press("bracketleft");
  EXPECT_TRUE(flown.waitFor([](const json& s) { return weatherOf(s).at("pace") == 1; }));
  flown.press("n");
  EXPECT_TRUE(flown.waitFor([](const json& s) { return weatherOf(s).at("mode") == "play"; }));
  flown.press("n");
  EXPECT_TRUE(flown.waitFor([](const json& s) { return weatherOf(s).at("mode") == "live"; }));
  flown.press("b");
  EXPECT_TRUE(flown.waitFor([](const json& s) { return weatherOf(s).at("bar") == false; }));
}

TEST(WeatherBarWindow, withoutWeatherDataThereIsNone) {
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown;
  flown.press("b");
  flown.press("F1");
  ASSERT_TRUE(flown.waitFor([](const json& s) { return s.at("window").at("menuOpen") == true; }));
  EXPECT_EQ(weatherOf(flown.statistics()).at("bar"), false);
  EXPECT_EQ(weatherOf(flown.statistics()).at("mode"), "");
}

class LiveWindow : public WeatherServerTest {
 protected:
  std::vector<std::string> words(const std::string& path) const {
    return {"--scene",    "terrain",   "--weather", answerFile_,  "--live",
            "open-meteo", "--live-at", "47.2,7.5",  "--live-url", url(path)};
  }
};

TEST_F(LiveWindow, aServerThatStallsStopsNoFrameAndIsNotWaitedForAtTheEnd) {
  // The server takes the question and sends nothing for a minute: the game draws on, and ends when asked to.
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown(words("/silent"));
  const auto steps = [](const json& s) { return s.at("steps").get<std::int64_t>(); };
  const std::int64_t before = steps(flown.statistics());
  EXPECT_TRUE(flown.waitFor([&](const json& s) { return steps(s) > before + 240; }));
  EXPECT_EQ(flown.window().at("fault"), "");
  flown.process().askToEnd();
  EXPECT_EQ(flown.process().wait(10), 0);
}

TEST_F(LiveWindow, aFailureIsOneLineInTheMenuAndTheFlightGoesOn) {
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown(words("/error"));
  EXPECT_TRUE(flown.waitFor([](const json& s) {
    return s.at("window").at("fault").get<std::string>().find("status 500") != std::string::npos;
  })) << flown.statistics().dump();
  EXPECT_EQ(weatherOf(flown.statistics()).at("mode"), "live");
}

}  // namespace
}  // namespace skydrop::test
