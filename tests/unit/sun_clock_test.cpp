// Who decides where the sun stands: two angles, or a clock.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <string>

#include "skydrop/core/settings_table.h"
#include "skydrop/render/frame/sky_light.h"
#include "skydrop/sky/almanac.h"
#include "skydrop/sky/refraction.h"

namespace skydrop::render {
namespace {

SunSettings clockAt(const char* utc) {
  SunSettings sun;
  sun.source = SunSource::clock;
  sun.utcMs = sky::parseInstant(utc).utcMs;
  return sun;
}

TEST(SunClock, byHandTheSunIsTheTwoAnglesAtAnyTime) {
  // Bit for bit what it was before there was a clock, whatever the clock's rows say.
  SunSettings sun{.elevationDegrees = 12, .azimuthDegrees = 200};
  const glm::dvec3 direction = sky::directionToSun(12, 200);
  EXPECT_EQ(directionToSun(sun), direction);
  sun.utcMs = 0;
  sun.timeScale = 3600;
  sun.shiftHours = 5;
  sun.latitudeDegrees = -80;
  EXPECT_EQ(directionToSun(sun, 5000), direction);
  EXPECT_EQ(SunSettings().source, SunSource::manual);
}

TEST(SunClock, theClockIsTheAlmanacAtItsTimeAndPlace) {
  SunSettings sun = clockAt("2026-03-20T17:00:00Z");
  sun.latitudeDegrees = 46;
  sun.longitudeDegrees = 7;
  sun.timeScale = 60;
  sun.shiftDays = 2;
  sun.shiftHours = -1.5;
  // 10 s of flight are 10 min: 17:00 + 2 d - 1:30 + 0:10.
  const double days = sky::daysSinceJ2000(sky::parseInstant("2026-03-22T15:40:00Z"));
  const glm::dvec3 expected = sky::worldDirection(sky::refracted(sky::sunAt(days, {46, 7}).horizontal));
  EXPECT_LT(glm::length(directionToSun(sun, 10) - expected), 1e-12);
  EXPECT_EQ(directionToSun(sun, 10), directionToSun(sun, 10));
  sun.elevationDegrees = -20;
  EXPECT_LT(glm::length(directionToSun(sun, 10) - expected), 1e-12) << "the angles rest";
  sun.timeScale = 0;
  EXPECT_EQ(directionToSun(sun, 10), directionToSun(sun, 0)) << "time is held";
}

TEST(SunClock, theLightFollowsIt) {
  // Morning, noon and night of one day, an hour a second.
  RenderSettings settings;
  settings.sun = clockAt("2026-06-21T00:00:00Z");
  settings.sun.timeScale = 3600;
  const auto light = [&](double second) { return skyLight(settings, 0, second); };
  EXPECT_LT(light(0).toSun.y, 0);
  EXPECT_GT(light(6).toSun.x, 0) << "east in the morning";
  EXPECT_GT(light(11.3).toSun.y, 0.89) << "64 degrees at noon";
  EXPECT_GT(light(11.3).sun.y, 2 * light(4).sun.y) << "less air above at noon";
  EXPECT_EQ(light(23).sun, glm::dvec3(0));
}

TEST(SunClock, theTimeIsWrittenAsText) {
  SunSettings sun;
  const core::SettingsTable table(sun);
  core::setField(table, "utc=2031-02-03T04:05:06+01:00");
  EXPECT_EQ(sky::instantText({sun.utcMs}), "2031-02-03T03:05:06Z");
  EXPECT_EQ(core::fieldText(table.at("utc")), "2031-02-03T03:05:06Z");
  EXPECT_EQ(sky::instantText({SunSettings().utcMs}), "2026-06-21T10:00:00Z");
  EXPECT_EQ(table.at("utc").note(), "Does nothing unless the clock moves the sun.");
  sun.source = SunSource::clock;
  EXPECT_EQ(table.at("utc").note(), "");
  EXPECT_EQ(table.at("elevationDegrees").note(), "Does nothing while the clock moves the sun.");
  sun.utcMs = 0 - std::int64_t{3600} * 24 * 366 * 100 * 1000;
  EXPECT_EQ(table.at("utc").note(), "Sun and moon are exact from 1950 to 2050 only.");
}

}  // namespace
}  // namespace skydrop::render
