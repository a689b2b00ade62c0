// The light of frames at night: what casts shadows, and how dusk becomes a moonlit night.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "render/frame/moon_view.h"
#include "skydrop/render/frame/sky_light.h"
#include "skydrop/sky/instant.h"
#include "skydrop/sky/night_light.h"

namespace skydrop::render {
namespace {

double luminance(const glm::dvec3& light) { return glm::dot(light, glm::dvec3(0.2126, 0.7152, 0.0722)); }

RenderSettings settingsAt(const char* utc, sky::SkyModel model = sky::SkyModel::shell) {
  RenderSettings settings;
  settings.sun.source = SunSource::clock;
  settings.sun.utcMs = sky::parseInstant(utc).utcMs;
  settings.sky.model = model;
  return settings;
}

constexpr const char* kFullMoon = "2026-09-26T21:00:00Z";  // 39 degrees up in the Alps

TEST(Moonlight, atNightTheMoonIsWhatCastsShadows) {
  // From where it stands, with what the air leaves of its illuminance.
  for (const sky::SkyModel model : {sky::SkyModel::shell, sky::SkyModel::closedForm}) {
    const RenderSettings settings = settingsAt(kFullMoon, model);
    const MoonView moon = moonView(settings.sun, 0);
    const SkyLight light = skyLight(settings, 500);
    EXPECT_EQ(light.direct.toSun, moon.direction);
    EXPECT_EQ(light.directRadiusRad, moon.radiusRad);
    const double outside = sky::moonIlluminance(moon.phaseAngleDegrees, moon.distanceKm);
    EXPECT_NEAR(luminance(light.direct.sunOutside) / outside, 1, 0.02);
    const double kept = luminance(light.direct.sun) / outside;
    EXPECT_TRUE(kept > 0.5 && kept < 0.9) << kept;
    EXPECT_NEAR(luminance(sky::sunIlluminance(light.direct, 500)) / luminance(light.direct.sun), 1, 1e-6);
    EXPECT_LT(light.toSun.y, -0.3) << "the sun's own sky is that of the night";
    EXPECT_GT(luminance(light.sky), 10 * luminance(light.night)) << "the air scatters moonlight";
  }
}

TEST(Moonlight, duskBecomesAMoonlitNightWithoutAJump) {
  // From sunset on, second by second: what lights level land, and the exposure, change by less than 1 %; and
  // it ends in a light that does not change any more, a fraction of a lux.
  RenderSettings settings = settingsAt("2026-09-26T17:00:00Z");
  double before = 0, exposureBefore = 0, last = 0;
  for (int second = 0; second <= 7200; second += 4) {
    const SkyLight light = skyLight(settings, 500, second);
    const double level =
        luminance(light.direct.sun) * std::max(light.direct.toSun.y, 0.0) + luminance(light.sky);
    if (before > 0) {
      ASSERT_NEAR(level / before, 1, 0.04) << second;
      ASSERT_NEAR(light.exposure / exposureBefore, 1, 0.04) << second;
    }
    before = level, exposureBefore = light.exposure, last = level;
  }
  EXPECT_TRUE(last > 2e-5 && last < 3e-4) << last << " klx";
}

TEST(Moonlight, byDayByHandAndWithoutMoonTheSunIsAll) {
  RenderSettings byHand = settingsAt(kFullMoon);
  byHand.sun.source = SunSource::manual;
  byHand.sun.elevationDegrees = -20;
  for (const RenderSettings& settings : {byHand, settingsAt("2026-09-26T10:00:00Z"),
                                         settingsAt("2026-09-11T22:00:00Z")}) {  // by day; new moon
    const SkyLight light = skyLight(settings, 500);
    EXPECT_FALSE(light.moon);
    EXPECT_EQ(light.direct.toSun, light.toSun);
    EXPECT_EQ(light.direct.sun, light.sun);
    EXPECT_EQ(light.directRadiusRad, kSunRadiusRad);
  }
}

TEST(Moonlight, isWorkedOutOnceAFrame) {
  // By all who ask in a frame of one clock and time, and again for the next.
  const RenderSettings settings = settingsAt(kFullMoon);
  MoonOfFrame frame;
  const SkyPlaces places = skyPlaces(settings, 500, 0, &frame);
  const SkyLight light = skyLight(settings, 500, 0, std::nullopt, {}, nullptr, &frame);
  const MoonView& moon = frame.at(settings.sun, 0);
  EXPECT_EQ(frame.made(), 1);
  EXPECT_EQ(moon.direction, moonView(settings.sun, 0).direction);
  EXPECT_EQ(light.moon->toMoon, moon.direction);
  EXPECT_EQ(places.moon->sine, moon.direction.y);
  skyLight(settings, 500, 4, std::nullopt, {}, nullptr, &frame);
  EXPECT_EQ(frame.made(), 2);
  MoonOfFrame byDay;
  skyLight(settingsAt("2026-09-26T10:00:00Z"), 500, 0, std::nullopt, {}, nullptr, &byDay);
  EXPECT_EQ(byDay.made(), 0);
}

TEST(Moonlight, theSkyGlowsAroundWhicheverLightsItMore) {
  // From sunset into the night, second by second: the sun's share of direction goes from 1 to 0, and then the
  // moon's from 0 to 1; never are both there, and neither jumps. The sun is 10 degrees down before its own is
  // gone.
  RenderSettings settings = settingsAt("2026-09-26T17:00:00Z");
  double sunBefore = 1, moonBefore = 0;
  const auto note = [&](const char* what, const SkyLight& light) {
    RecordProperty(what, std::to_string(glm::degrees(std::asin(light.toSun.y))));
  };
  for (int second = 0; second <= 7200; second += 4) {
    const SkyLight light = skyLight(settings, 500, second);
    EXPECT_EQ(light.sunGlow * light.moonGlow, 0) << second;
    EXPECT_LE(light.sunGlow, sunBefore) << second;
    EXPECT_GE(light.moonGlow, moonBefore) << second;
    EXPECT_LT(sunBefore - light.sunGlow + light.moonGlow - moonBefore, 0.05) << second;
    EXPECT_TRUE(light.sunGlow > 0 || light.toSun.y < std::sin(glm::radians(-13.0)));
    if (sunBefore == 1 && light.sunGlow < 1) note("sunFades", light);
    if (sunBefore > 0 && light.sunGlow == 0) note("sunFaded", light);
    if (moonBefore < 1 && light.moonGlow == 1) note("moonGlows", light);
    sunBefore = light.sunGlow, moonBefore = light.moonGlow;
  }
  EXPECT_EQ(sunBefore, 0);
  EXPECT_EQ(moonBefore, 1);
}

}  // namespace
}  // namespace skydrop::render
