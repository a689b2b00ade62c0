// Eyes that get used to the light in view, in simulated time.
#include "skydrop/render/frame/eye_adaptation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "skydrop/core/hash.h"
#include "support/margin.h"

namespace skydrop::render {
namespace {

using Eye = EyeAdaptation;

// What the eye is adapted to after some seconds of frames at a rate, in the light of a function of time.
template <class Light>
double adaptedAfter(double seconds, double rate, Light light) {
  Eye eye;
  const int frames = static_cast<int>(std::lround(seconds * rate));
  for (int i = 0; i <= frames; ++i) eye.follow(light(i / rate), i / rate);
  return *eye.level();
}

TEST(EyeAdaptation, theFirstFrameAndThatAfterACutAreSettled) {
  // Before any frame there is no level, which means that of the frame's own light.
  Eye eye;
  EXPECT_FALSE(eye.level());
  eye.follow(50, 3);
  EXPECT_EQ(eye.level(), 50);
  eye.follow(1, 3.1);
  EXPECT_GT(*eye.level(), 40);
  eye.cut();
  EXPECT_FALSE(eye.level());
  eye.follow(1, 3.2);
  EXPECT_EQ(eye.level(), 1);
}

TEST(EyeAdaptation, theTimeConstantsAreThose) {
  // After one time constant an e-th of the way is left, as a ratio of levels, by day and by night.
  for (const double scale : {1e2, 1e-4}) {
    const auto left = [&](double from, double to, double seconds) {
      const double level = adaptedAfter(seconds, 1000, [&](double t) { return t == 0 ? from : to; });
      return std::log(level / to) / std::log(from / to);
    };
    EXPECT_NEAR(left(100 * scale, scale, Eye::kToDarknessS), std::exp(-1), 1e-9);
    EXPECT_NEAR(left(scale, 100 * scale, Eye::kToBrightnessS), std::exp(-1), 1e-9);
  }
  EXPECT_GT(Eye::kToDarknessS, 4 * Eye::kToBrightnessS);
}

TEST(EyeAdaptation, itDoesNotOvershoot) {
  // Each frame ends between what the eye was adapted to and the light, in random light at random steps.
  core::RandomStream random{7, 0};
  Eye eye;
  double seconds = 0;
  eye.follow(1, seconds);
  for (int i = 0; i < 10000; ++i) {
    const double before = *eye.level(), light = std::pow(10, 8 * random.nextUnit() - 6);
    seconds += 0.3 * random.nextUnit();
    eye.follow(light, seconds);
    const double slack = 1e-12 * (before + light);
    ASSERT_GE(*eye.level(), std::min(before, light) - slack);
    ASSERT_LE(*eye.level(), std::max(before, light) + slack);
  }
}

TEST(EyeAdaptation, framesPerSecondMakeNoDifference) {
  // In light that stays, none but rounding. In light that swings by a factor of 30 within two seconds, at 30
  // frames a second or 2311: within 0.02 stops of each other.
  const auto step = [](double t) { return t < 0.5 ? 100.0 : 1e-3; };
  const auto swing = [](double t) { return std::pow(30, std::sin(3.14159 * t)); };
  const double exact = adaptedAfter(4, 2311, swing);
  double worst = 0;
  for (const double rate : {30.0, 60.0, 144.0}) {
    EXPECT_NEAR(adaptedAfter(4, rate, step) / adaptedAfter(4, 2000, step), 1, 0.1) << rate;
    worst = std::max(worst, std::abs(std::log2(adaptedAfter(4, rate, swing) / exact)));
    EXPECT_NEAR(adaptedAfter(2, rate, [](double t) { return t == 0 ? 9.0 : 2.0; }) /
                    adaptedAfter(2, 1000, [](double t) { return t == 0 ? 9.0 : 2.0; }),
                1, 1e-9);
  }
  std::printf("frame rates differ by at most %.4f stops\n", worst);
  EXPECT_LT(worst, 0.02);
}

TEST(EyeAdaptation, heldTimeHoldsTheEyeAndAJumpIsACut) {
  Eye eye;
  eye.follow(100, 5);
  eye.follow(1, 5);
  EXPECT_EQ(eye.level(), 100);
  eye.follow(1, 5 + 2 * Eye::kLongestStepS);
  EXPECT_EQ(eye.level(), 1);
  eye.follow(100, 2);  // back in time
  EXPECT_EQ(eye.level(), 100);
}

TEST(EyeAdaptation, eyesInATimeLapseKeepUpWithTheClock) {
  // An hour a second: what would take the eye minutes of the clock is over in a frame.
  Eye eye;
  eye.follow(100, 0);
  eye.follow(1, 1.0 / 60, 3600);
  EXPECT_NEAR(*eye.level(), 1, 1e-6);
}

TEST(EyeAdaptation, S70_lightThatIsNoNumberIsNotFollowed) {
  // NaN, infinite, none and negative light leave the eye as it is, before the first frame and after; a time
  // that is no number is a cut.
  test::noFaults("S70", "values that are not finite");
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double light : {std::nan(""), kInfinity, -kInfinity, 0.0, -3.0}) {
    Eye eye;
    eye.follow(light, 0);
    EXPECT_FALSE(eye.level()) << light;
    eye.follow(10, 0.1);
    eye.follow(light, 0.2);
    EXPECT_EQ(eye.level(), 10) << light;
  }
  for (const double light : {1e-300, 1e300, std::numeric_limits<double>::denorm_min()}) {
    Eye eye;
    eye.follow(1, 0);
    for (int i = 1; i < 100; ++i) eye.follow(light, i * 0.5);
    EXPECT_TRUE(std::isfinite(*eye.level()) && *eye.level() > 0) << light;
  }
  Eye eye;
  eye.follow(10, 0);
  eye.follow(20, std::nan(""));
  EXPECT_EQ(eye.level(), 20);
}

View towards(double yawDegrees, double pitchDegrees) {
  const double yaw = yawDegrees * 3.14159265358979 / 180, pitch = pitchDegrees * 3.14159265358979 / 180;
  View view;
  const glm::dvec3 forward(std::cos(pitch) * std::cos(yaw), std::sin(pitch), std::cos(pitch) * std::sin(yaw));
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
  const glm::dvec3 up = glm::cross(right, forward);
  view.worldToView = glm::transpose(glm::dmat3(right, up, -forward));
  return view;
}

TEST(EyeAdaptation, theLightInViewIsThatOfSkyLandAndSun) {
  // Along the horizon away from the sun it is the level of the frame's light; the sky is brighter than the
  // land, and the sun in view is brighter than either.
  RenderSettings settings;
  settings.sun.elevationDegrees = 20;
  settings.sun.azimuthDegrees = 90;  // along +x: yaw 0
  const SkyLight light = skyLight(settings, 500);
  EXPECT_NEAR(levelInView(light, towards(180, 0)) / light.level, 1, 1e-9);
  EXPECT_GT(levelInView(light, towards(180, 25)), 1.1 * light.level);
  EXPECT_LT(levelInView(light, towards(180, -40)), 0.8 * light.level);
  EXPECT_GT(levelInView(light, towards(0, 20)), 1.3 * levelInView(light, towards(180, 20)));
}

TEST(EyeAdaptation, S71_theLightInViewIsFiniteAndNearTheLevelInAnyLight) {
  // Sun from the zenith to midnight, views straight up and down: within a factor of 4 of the level.
  test::noFaults("S71", "values that are not finite");
  RenderSettings settings;
  for (const double elevation : {90.0, 5.0, 0.0, -6.0, -12.0, -30.0}) {
    settings.sun.elevationDegrees = elevation;
    for (const double height : {2.0, 20000.0}) {
      const SkyLight light = skyLight(settings, height);
      for (const double pitch : {-89.99, -20.0, 0.0, 20.0, 89.99}) {
        const double level = levelInView(light, towards(30, pitch));
        ASSERT_TRUE(level >= light.level / 4 && level <= 4 * light.level) << elevation << ' ' << pitch;
      }
    }
  }
  SkyLight dark;
  dark.level = 1;
  EXPECT_GT(levelInView(dark, View()), 0);
}

TEST(EyeAdaptation, exposureFollowsWhatTheEyeIsAdaptedTo) {
  // Without a level, or with one that is no number above 0, exposure is that of the frame's own light.
  const RenderSettings settings;
  const SkyLight own = skyLight(settings, 500);
  EXPECT_EQ(skyLight(settings, 500, 0, own.level).exposure, own.exposure);
  EXPECT_GT(skyLight(settings, 500, 0, own.level / 10).exposure, 6 * own.exposure);
  for (const double level : {std::nan(""), 0.0, -1.0})
    EXPECT_EQ(skyLight(settings, 500, 0, level).exposure, own.exposure) << level;
}

}  // namespace
}  // namespace skydrop::render
