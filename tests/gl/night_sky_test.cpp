// Moon and stars in frames: where they are, how much light they send, what hides them, and when they are left
// out.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "app/settings/settings.h"
#include "render/frame/moon_view.h"
#include "skydrop/core/hash.h"
#include "skydrop/render/frame/sky_clock.h"
#include "skydrop/render/frame/sky_light.h"
#include "skydrop/render/sky/moon_pass.h"
#include "skydrop/render/sky/stars_pass.h"
#include "skydrop/sky/almanac.h"
#include "skydrop/sky/night_light.h"
#include "skydrop/sky/refraction.h"
#include "support/frame_test.h"
#include "support/light_probe.h"
#include "support/margin.h"
#include "support/row_steps.h"

namespace skydrop::render {
namespace {

constexpr int kWidth = 96, kHeight = 64;
constexpr double kHeightM = 1000;

double luminance(const glm::vec4& light) {
  return glm::dot(glm::vec3(light), glm::vec3(0.2126f, 0.7152f, 0.0722f));
}

double yawOf(const glm::dvec3& direction) { return glm::degrees(std::atan2(direction.z, direction.x)); }
double pitchOf(const glm::dvec3& direction) { return glm::degrees(std::asin(direction.y)); }

class NightSkyGLTest : public test::FrameTest {
 protected:
  void SetUp() override {
    FrameTest::SetUp();
    if (IsSkipped()) return;
    settings_.sun.source = SunSource::clock;
    settings_.sun.utcMs = sky::parseInstant("2026-09-26T21:00:00Z").utcMs;  // full moon, 39 degrees up
    renderer().add(std::make_unique<test::LightProbe>(light_));
  }
  MoonPass& addMoon() {
    auto pass = std::make_unique<MoonPass>(context(), settings_.sun);
    MoonPass& moon = *pass;
    renderer().add(std::move(pass));
    return moon;
  }
  StarsPass& addStars(const std::vector<sky::Star>& stars) {
    auto pass = std::make_unique<StarsPass>(context(), stars, stars_);
    StarsPass& added = *pass;
    renderer().add(std::move(pass));
    return added;
  }
  // A star that appears in a direction of the world.
  sky::Star starAt(const glm::dvec3& direction, double magnitude) const {
    sky::Horizontal place = sky::horizontalOf(direction);
    place.elevationDegrees = sky::geometricElevation(place.elevationDegrees);
    sky::Star star;
    const glm::dmat3 toWorld = sky::j2000ToWorld(clockDays(settings_.sun, 0), placeOf(settings_.sun));
    star.direction = glm::transpose(toWorld) * sky::worldDirection(place);
    star.magnitude = magnitude, star.colorIndex = 0.3;
    return star;
  }
  View towards(const glm::dvec3& direction, double fovDegrees = 60) {
    settings_.camera.fovDegrees = fovDegrees;
    return pose({0, kHeightM, 0}, yawOf(direction), pitchOf(direction), 0, kWidth, kHeight);
  }
  // Illuminance that the picture sends to the eye, after exposure, and the middle of that light in pixels
  // from the lower left corner.
  struct Received {
    double light = 0;
    glm::dvec2 middle{0};
  };
  Received received(const View& view) {
    draw(view);
    Received sum;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const double cosine = glm::dot(rayDirection(view, {x + 0.5, y + 0.5}), view.forward());
        const double solidAngle = std::pow(view.pixelAngleRad(), 2) * cosine * cosine * cosine;
        const double here = luminance(light_[static_cast<std::size_t>(y * kWidth + x)]) * solidAngle;
        sum.light += here;
        sum.middle += here * glm::dvec2(x + 0.5, y + 0.5);
      }
    }
    if (sum.light > 0) sum.middle /= sum.light;
    return sum;
  }
  // Of light from outside, by what the frame's atmosphere leaves of it.
  double through(const glm::dvec3& direction) const {
    const SkyLight light = skyLight(settings_, kHeightM);
    const glm::dvec3 kept = light.isShell()
                                ? light.view->at(sky::SkyLayer::left, direction.y, 1)
                                : glm::exp(-light.column.depth * core::shared::f64::airMass(direction.y));
    return glm::dot(kept, glm::dvec3(0.2126, 0.7152, 0.0722)) * light.exposure;
  }

  StarsSettings stars_{.faintestMagnitude = 6, .brightness = 1, .twinkle = 0};
  std::vector<glm::vec4> light_;
};

TEST_F(NightSkyGLTest, aStarStandsWhereTheAlmanacSaysAndSendsTheLightOfItsMagnitude) {
  // Within a twentieth of a pixel and 4 %, in the middle of the picture and towards its corner, high up and
  // low, where refraction is four pixels.
  const glm::dvec3 high = glm::normalize(glm::dvec3(1, 0.8, -0.3)),
                   low = glm::normalize(glm::dvec3(-1, 0.06, 0.4));
  for (const auto& [direction, aside] : {std::pair{high, 0.0}, {high, 20.0}, {low, 0.0}, {low, 12.0}}) {
    const sky::Star star = starAt(direction, 1.5);
    renderer().setGroup({"star", 0});
    addStars({star});
    const View view =
        pose({0, kHeightM, 0}, yawOf(direction) + aside, pitchOf(direction), 0, kWidth, kHeight);
    const Received star1 = received(view);
    const glm::dvec3 seen = view.worldToView * direction;
    const double perPixel = std::tan(view.fovYRad / 2) * 2 / kHeight;
    EXPECT_NEAR(star1.middle.x, kWidth / 2.0 + seen.x / -seen.z / perPixel, 0.05);
    EXPECT_NEAR(star1.middle.y, kHeight / 2.0 + seen.y / -seen.z / perPixel, 0.05);
    const double expected = sky::illuminanceOfMagnitude(1.5) * through(direction);
    EXPECT_NEAR(star1.light / expected, 1, 0.04) << direction.y << ' ' << aside;
    renderer().removeGroup("star");
  }
}

TEST_F(NightSkyGLTest, aStarIsAsBrightWhereverBetweenPixelsItStands) {
  // Its light does not change by more than 2 % as the camera turns by tenths of a pixel.
  const glm::dvec3 direction = glm::normalize(glm::dvec3(1, 0.8, -0.3));
  addStars({starAt(direction, 2)});
  double least = 1e30, most = 0;
  for (int i = 0; i < 10; ++i) {
    const double turn = i * 0.1 * 60.0 / kHeight;
    const View view =
        pose({0, kHeightM, 0}, yawOf(direction) + turn, pitchOf(direction) + 0.6 * turn, 0, kWidth, kHeight);
    const double light = received(view).light;
    least = std::min(least, light), most = std::max(most, light);
  }
  EXPECT_GT(least, 0);
  EXPECT_LT(most / least, 1.02);
}

TEST_F(NightSkyGLTest, theMoonHidesTheStarsBehindIt) {
  const MoonView moon = moonView(settings_.sun, 0);
  const glm::dvec3 aside = glm::normalize(glm::cross(moon.direction, glm::dvec3(0, 1, 0)));
  const auto beside = [&](double radii) {
    return glm::normalize(moon.direction + std::tan(radii * moon.radiusRad) * aside);
  };
  settings_.exposureStops = 4;
  const View view = towards(moon.direction, 20);
  addMoon();
  const double alone = received(view).light;
  addStars({starAt(beside(0.3), -1), starAt(beside(0.9), -1)});
  EXPECT_EQ(received(view).light, alone);
  addStars({starAt(beside(4), -1)});
  EXPECT_GT(received(view).light, alone);
}

TEST_F(NightSkyGLTest, theMoonSendsItsIlluminanceFromWhereTheAlmanacHasIt) {
  // Full, gibbous, half and crescent, within 8 % (the seas' shade averages to 1 within that) and a tenth of
  // its radius plus half of what the dark side moves the middle of its light. Exposed so that no part is
  // bounded.
  addMoon();
  for (const char* utc : {"2026-09-26T21:00:00Z", "2026-09-22T21:00:00Z", "2026-09-18T18:00:00Z"}) {
    settings_.sun.utcMs = sky::parseInstant(utc).utcMs;
    renderer().find<MoonPass>()->apply(settings_.sun);
    const MoonView moon = moonView(settings_.sun, 0);
    ASSERT_GT(moon.direction.y, 0.1) << utc;
    const View view = towards(moon.direction, 20);
    settings_.exposureStops = 0;
    settings_.exposureStops = std::log2(1 / (sky::moonRadiance(moon.phaseAngleDegrees, moon.distanceKm) *
                                             skyLight(settings_, kHeightM).exposure));
    const Received disc = received(view);
    const double expected =
        sky::moonIlluminance(moon.phaseAngleDegrees, moon.distanceKm) * through(moon.direction);
    EXPECT_NEAR(disc.light / expected, 1, 0.08) << utc;
    const double radiusPixels = moon.radiusRad / view.pixelAngleRad();
    EXPECT_LT(glm::length(disc.middle - glm::dvec2(kWidth, kHeight) / 2.0), radiusPixels) << utc;
  }
}

TEST_F(NightSkyGLTest, theBrightLimbLiesWhereTheAlmanacTiltsIt) {
  // The middle of the light of a half moon, from the middle of the disc, within 10 degrees (the seas pull at
  // it).
  addMoon();
  settings_.sun.utcMs = sky::parseInstant("2026-09-18T18:00:00Z").utcMs;
  renderer().find<MoonPass>()->apply(settings_.sun);
  const MoonView moon = moonView(settings_.sun, 0);
  settings_.exposureStops = -4;
  const Received disc = received(towards(moon.direction, 20));
  const glm::dvec2 aside = disc.middle - glm::dvec2(kWidth, kHeight) / 2.0;
  ASSERT_GT(glm::length(aside), 0.3);
  const double tilt =
      sky::moonPhase(clockDays(settings_.sun, 0), placeOf(settings_.sun)).brightLimbTiltDegrees;
  const glm::dvec2 limb(-std::sin(glm::radians(tilt)),
                        std::cos(glm::radians(tilt)));  // counter-clockwise from up
  EXPECT_GT(glm::dot(glm::normalize(aside), limb), std::cos(glm::radians(10.0))) << tilt;
}

TEST_F(NightSkyGLTest, whatCannotBeSeenIsLeftOutWithAReason) {
  MoonPass& moon = addMoon();
  StarsPass& stars = addStars({starAt({0, 1, 0}, 0)});
  const auto reasons = [&](const View& view) {
    FrameInput input = gameFrame(snapshot_, view, features_);
    input.sunSine = directionToSun(settings_.sun).y;
    moon.apply(settings_.sun);
    return std::pair(moon.skipReason(input).value_or(""), stars.skipReason(input).value_or(""));
  };
  const glm::dvec3 toMoon = moonView(settings_.sun, 0).direction;
  EXPECT_EQ(reasons(towards(toMoon)), std::pair(std::string(), std::string()));
  EXPECT_EQ(reasons(towards(-toMoon)).first, "the moon is out of view");
  settings_.sun.shiftHours = -12;
  EXPECT_EQ(reasons(towards(toMoon)),
            std::pair(std::string("the moon is below the horizon"), std::string("the sun is up")));
  settings_.sun.source = SunSource::manual;
  settings_.sun.elevationDegrees = -20;
  EXPECT_EQ(reasons(towards(toMoon)),
            std::pair(std::string("the sun is set by hand (sky.sun)"), std::string()));
  stars_.brightness = 0;
  stars.apply(stars_);
  EXPECT_EQ(reasons(towards(toMoon)).second, "the brightness is 0");
}

TEST_F(NightSkyGLTest, everyTenthOfEveryRowOfTheStarsMakesADifference) {
  // In a sky of stars of all magnitudes.
  std::vector<sky::Star> many;
  for (int i = 0; i < 400; ++i) {
    const double magnitude = -1.4 + 7.4 * i / 400, turn = 2.399963 * i, up = 0.05 + 0.9 * i / 400;
    const double level = std::sqrt(1 - up * up);
    many.push_back(starAt({level * std::cos(turn), up, level * std::sin(turn)}, magnitude));
  }
  StarsPass& stars = addStars(many);
  settings_.exposureStops = 6;
  app::Settings settings;
  const core::SettingsTable table(settings);
  snapshot_.simulatedSeconds = 0.13;
  const auto observe = [&] {
    stars.apply(settings.stars);
    core::StateHasher h;
    draw(pose({0, kHeightM, 0}, 40, 50, 0, kWidth, kHeight));
    for (const glm::vec4& texel : light_)
      for (int c = 0; c < 3; ++c) h.add(static_cast<double>(texel[c]));
    return h.value();
  };
  EXPECT_EQ(test::expectNoIdleSteps(table, {"stars."}, observe), 3);
}

class NightSkyStabilityGL : public NightSkyGLTest {
 protected:
  // Of all texels: finite, not negative, within the half float's clip.
  void expectFinite(const std::string& where) const {
    for (const glm::vec4& texel : light_)
      for (int c = 0; c < 3; ++c) ASSERT_TRUE(texel[c] >= 0 && texel[c] <= 60001.0f) << where;
  }
};

TEST_F(NightSkyStabilityGL, S80_theMoonExactlyNewAndExactlyFull) {
  // Its light at phase angles of 0 and 180 degrees and next to both: finite, not negative, falling. In the
  // picture: at the full moon of September 2026, and at a new moon that stands before the sun.
  test::noFaults("S80", "differences");
  double last = 1e30;
  for (const double angle : {0.0, 1e-12, 1e-6, 1.0, 90.0, 179.0, 180 - 1e-6, 180 - 1e-12, 180.0}) {
    const double light = sky::moonIlluminance(angle, 384400), radiance = sky::moonRadiance(angle, 384400);
    EXPECT_TRUE(std::isfinite(radiance) && radiance >= 0) << angle;
    EXPECT_TRUE(light >= 0 && light <= last) << angle;
    last = light;
  }
  addMoon();
  settings_.sun.latitudeDegrees = 65.2, settings_.sun.longitudeDegrees = -25.2;  // in the path of the eclipse
  for (const char* utc : {"2026-09-26T16:49:00Z", "2026-08-12T17:36:30Z", "2026-08-12T17:46:00Z"}) {
    settings_.sun.utcMs = sky::parseInstant(utc).utcMs;
    renderer().find<MoonPass>()->apply(settings_.sun);
    const MoonView moon = moonView(settings_.sun, 0);
    received(towards(moon.direction, 5));
    expectFinite(utc);
  }
  const glm::dvec3 sun = directionToSun(settings_.sun), moon = moonView(settings_.sun, 0).direction;
  EXPECT_LT(glm::degrees(std::acos(std::min(glm::dot(sun, moon), 1.0))), 0.1) << "they are at one place";
}

TEST_F(NightSkyStabilityGL, S81_nextToTheMoonNoHalfFloatOverflows) {
  // In a picture of 2 degrees about the full moon, sixteen stops over, through both skies: finite and bright.
  test::noFaults("S81", "violations");
  addMoon();
  addStars({starAt(moonView(settings_.sun, 0).direction, -30)});
  settings_.exposureStops = 16;
  for (const sky::SkyModel model : {sky::SkyModel::closedForm, sky::SkyModel::shell}) {
    settings_.sky.model = model;
    EXPECT_GT(received(towards(moonView(settings_.sun, 0).direction, 2)).light, 0);
    expectFinite("sixteen stops over");
  }
}

TEST_F(NightSkyStabilityGL, S82_starsAtThePolesTheZenithTheHorizonAndBelowIt) {
  // From both poles, from the equator, and from within 1e-9 degrees of a pole: stars exactly at the celestial
  // poles, in the zenith, on the horizon and in the nadir, in views towards each. Nothing comes from below
  // the ground.
  test::noFaults("S82", "violations");
  std::vector<sky::Star> stars;
  for (const glm::dvec3& direction :
       {glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1), glm::dvec3(1, 0, 0), glm::dvec3(-1, 0, 0)})
    stars.push_back({.direction = direction, .magnitude = -1, .colorIndex = 0.3});
  for (const double latitude : {90.0, -90.0, 90 - 1e-9, 0.0}) {
    settings_.sun.latitudeDegrees = latitude;
    settings_.sun.utcMs =
        sky::parseInstant(latitude < 0 ? "2026-06-21T00:00:00Z" : "2026-12-21T00:00:00Z").utcMs;
    std::vector<sky::Star> all = stars;
    for (const glm::dvec3& direction : {glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0)})
      all.push_back(starAt(direction, -1));
    renderer().setGroup({"stars", 0});
    addStars(all);
    for (const double pitch : {90.0, 0.0, -90.0}) {
      const double light = received(pose({0, kHeightM, 0}, 0, pitch, 0, kWidth, kHeight)).light;
      expectFinite(std::to_string(latitude) + " " + std::to_string(pitch));
      if (pitch < 0) {
        EXPECT_EQ(light, 0) << latitude;
      } else if (pitch > 80) {
        EXPECT_GT(light, 0) << latitude;
      }
    }
    renderer().removeGroup("stars");
  }
}

TEST_F(NightSkyStabilityGL, S83_aYearOfLightAtThreeThousandSixHundredTimes) {
  // The light of sun, moon and sky each 9 hours and 13 minutes of a simulated year: finite, never below the
  // night's, and what casts shadows is above the horizon or sends nothing.
  settings_.sky.model = sky::SkyModel::closedForm;
  settings_.sun.timeScale = 3600;
  int moonlit = 0;
  for (int i = 0; i < 950; ++i) {
    const double seconds = i * (9 * 3600 + 13 * 60) / 3600.0;  // of the simulation
    const SkyLight light = skyLight(settings_, kHeightM, seconds);
    ASSERT_TRUE(std::isfinite(light.exposure) && light.exposure > 0) << i;
    for (int c = 0; c < 3; ++c) {
      ASSERT_TRUE(std::isfinite(light.sky[c]) && light.sky[c] > 0) << i;
      ASSERT_TRUE(std::isfinite(light.direct.sun[c]) && light.direct.sun[c] >= 0) << i;
    }
    ASSERT_TRUE(test::holds("S83", test::apart(glm::length(light.direct.toSun), 1), test::atMost(1e-12),
                            "of length 1"))
        << i;
    moonlit += light.moon.has_value();
  }
  EXPECT_GT(moonlit, 100);
}

}  // namespace
}  // namespace skydrop::render
