// Rise, set and transit against a table of Skyfield with JPL's DE421 (tests/unit/sky_tables).
#include "skydrop/sky/rise_and_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

#include "support/csv.h"
#include "support/paths.h"

namespace skydrop::sky {
namespace {

double daysOf(std::string_view utc) { return daysSinceJ2000(parseInstant(utc)); }

Events eventsOf(const std::string& body, double days, const Place& place) {
  return body == "sun" ? sunEvents(days, place) : moonEvents(days, place);
}

TEST(RiseAndSet, areThoseOfThePreciseAlmanac) {
  // 66 times and places, sun and moon, the first of each within two days. Where the body passes the horizon
  // at a slant, an error in elevation of 0.007 degrees (the moon's at most) shifts it by that over its speed
  // there: the shift is held to that, and a second. Where it grazes the horizon by less than 0.02 degrees, it
  // may be missed.
  int compared = 0, missing = 0;
  double worstSun = 0, worstMoon = 0;
  for (const test::CsvRow& row : test::readCsv(test::sourceDir() + "/tests/unit/sky_tables/events.csv")) {
    const Place place{test::numberIn(row, "latitude"), test::numberIn(row, "longitude")};
    const std::string& body = row.at("body");
    const double days = daysOf(row.at("utc"));
    const Events events = eventsOf(body, days, place);
    const double lowest = test::numberIn(row, "lowest"), highest = test::numberIn(row, "highest");
    if (std::min(std::abs(lowest), std::abs(highest)) < 0.02) continue;
    const auto compare = [&](const char* name, const std::optional<double>& event, double degrees) {
      const std::string where = body + "'s " + name + " " + row.at("utc") + " at " + row.at("latitude");
      EXPECT_EQ(event.has_value(), !row.at(name).empty()) << where;
      missing += row.at(name).empty();
      if (!event || row.at(name).empty()) return;
      ++compared;
      const double seconds = std::abs(*event - daysOf(row.at(name))) * 86400;
      (body == "sun" ? worstSun : worstMoon) = std::max(body == "sun" ? worstSun : worstMoon, seconds);
      double speed =
          360.0 / 86400 * 0.95;  // degrees a second: of the hour angle, the moon's being the slowest
      if (std::string_view(name) != "transit") {
        const auto height = [&](double time) {
          return (body == "sun" ? sunAt(time, place) : moonAt(time, place)).horizontal.elevationDegrees;
        };
        speed = std::abs(height(*event + 30.0 / 86400) - height(*event - 30.0 / 86400)) / 60;
      } else {
        degrees /= std::max(std::cos(0.5), 1e-3);  // in right ascension, up to 28.7 degrees off the equator
      }
      EXPECT_LT(seconds, 1 + degrees / speed) << where;
    };
    const double error = body == "sun" ? 0.001 : 0.007;
    compare("rise", events.rise, error);
    compare("set", events.set, error);
    compare("transit", events.transit, error);
    if (!events.rise && !events.set)
      EXPECT_EQ(events.horizon, lowest > 0 ? Horizon::staysAbove : Horizon::staysBelow) << row.at("utc");
    else
      EXPECT_EQ(events.horizon, Horizon::risesAndSets);
  }
  std::printf("%d compared, %d do not happen; worst: sun %.2f s, moon %.2f s\n", compared, missing, worstSun,
              worstMoon);
  EXPECT_GT(compared, 250);
  EXPECT_GT(missing, 10);
}

TEST(RiseAndSet, midnightSunAndPolarNightHaveNone) {
  const Place northCape{71.17, 25.78};
  const Events summer = sunEvents(daysOf("2026-06-21"), northCape),
               winter = sunEvents(daysOf("2026-12-21"), northCape);
  EXPECT_FALSE(summer.rise || summer.set);
  EXPECT_EQ(summer.horizon, Horizon::staysAbove);
  EXPECT_FALSE(winter.rise || winter.set);
  EXPECT_EQ(winter.horizon, Horizon::staysBelow);
  EXPECT_TRUE(summer.transit && winter.transit) << "noon comes all the same";
}

TEST(RiseAndSet, theFirstOfTheYearAtAPoleIsTheOnlyOne) {
  // At the north pole the sun rises on 18 March, two days before the equinox, and does not set until
  // September.
  const Place pole{90, 0};
  const Events march = sunEvents(daysOf("2026-03-17T12:00"), pole);
  ASSERT_TRUE(march.rise);
  EXPECT_FALSE(march.set);
  EXPECT_EQ(march.horizon, Horizon::risesAndSets);
  const Body sun = sunAt(*march.rise, pole);
  EXPECT_NEAR(sun.horizontal.elevationDegrees, -34.0 / 60 - sun.radiusDegrees, 1e-6);
}

TEST(RiseAndSet, aSunThatGrazesTheHorizonIsFoundBetweenTheSteps) {
  // Towards the latitude where the winter sun stays below the horizon its day shrinks to nothing, far below a
  // step of ten minutes: halving finds days of less than a minute, and each has a rise and a set.
  const auto noonAt = [](double latitude) { return sunEvents(daysOf("2026-12-21T06:00"), {latitude, 0}); };
  const auto lengthOf = [](const Events& noon) { return *noon.set - *noon.rise; };
  double sunny = 66.5, dark = 68;
  double shortest = lengthOf(noonAt(sunny));
  for (int i = 0; i < 22; ++i) {
    const double latitude = (sunny + dark) / 2;
    const Events noon = noonAt(latitude);
    ASSERT_EQ(noon.rise.has_value(), noon.set.has_value()) << latitude;
    if (!noon.rise || *noon.rise > daysOf("2026-12-21T18:00")) {  // the sun of the next noon stands higher
      dark = latitude;
      continue;
    }
    sunny = latitude;
    ASSERT_GE(lengthOf(noon), 0) << latitude;
    ASSERT_LE(lengthOf(noon), shortest + 2 * kEventToleranceDays) << latitude;
    shortest = lengthOf(noon);
  }
  EXPECT_LT(shortest, 1.0 / 1440);
}

}  // namespace
}  // namespace skydrop::sky
