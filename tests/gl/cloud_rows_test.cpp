// Hard cases of the clouds' pass (tests/stability/cases.json): what frames hold to at the edges of their
// input.
#include "support/cloud_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "skydrop/core/shared.h"
#include "support/ground_pass.h"
#include "support/margin.h"
#include "support/shared_noise.h"

namespace skydrop::render {
namespace {

namespace f32 = core::shared::f32;
namespace f64 = core::shared::f64;

using test::CloudRowsGLTest;

constexpr int kWidth = test::kCloudRowsWidth, kHeight = test::kCloudRowsHeight;

TEST_F(CloudRowsGLTest, C02_noExtinctionShowsExactlyTheBackground) {
  // Every tier marches and adds nothing, to the last bit.
  test::noFaults("C02", "differences");
  addSky();
  addClouds(test::sharedNoise());
  const std::vector<glm::vec4> background = withoutClouds(below());
  clouds_.layers[0].extinction = 0;
  for (const clouds::CloudTier tier :
       {clouds::CloudTier::low, clouds::CloudTier::high, clouds::CloudTier::reference}) {
    clouds_.march = test::rowsOf(tier);
    EXPECT_TRUE(sceneFrom(below()) == background);
    EXPECT_GT(system_->lastWork().tiles, 0u) << "nothing was marched";
  }
}

TEST_F(CloudRowsGLTest, C04_extinctionWithoutBoundShowsTheSourceWhereTheRayEnters) {
  // From within, the light of sky and ground in the middle of the first step, whatever its length; nothing of
  // the sun comes through to there, and nothing of what is behind. Within the 1e-3 by which a half float may
  // be cut.
  addClouds(test::plainNoise());
  clouds_ = test::plainSettings();
  clouds_.layers[0].extinction = 1e30;
  const View view = small({0, 2500, 0}, 30, 5);
  const SkyLight light = skyLight(settings_, view.position.y);
  for (const double stepM : {1.0, 4.0, 16.0}) {
    clouds_.march.stepM = stepM;
    const std::vector<glm::vec4> rays = cloudsFrom(view);
    for (int y = 0; y < kHeight; ++y) {
      const glm::vec4& ray = rays[static_cast<std::size_t>(y * kWidth + 20)];
      const double rise = rayDirection(view, {20.5, y + 0.5}).y * 0.5 * stepM;
      const clouds::CloudLayerSettings& layer = clouds_.layers[0];
      const double height = (view.position.y + rise - layer.cloudHeight) / layer.thickness;
      const glm::dvec3 source = (light.sky * f64::scatteredSky(height) +
                                 light.ground * (groundShare() * f64::scatteredGround(height))) *
                                light.exposure;
      ASSERT_EQ(ray.w, 0);
      for (int c = 0; c < 3; ++c)
        ASSERT_TRUE(test::holds("C04", test::apart(ray[c] / source[c], 1), test::atMost(1e-3), "relative"))
            << stepM << ' ' << y;
    }
  }
}

TEST_F(CloudRowsGLTest, C05_noiseOutOfRangeIsNoMoreThanAllCloud) {
  // Where textures hold 7 in place of 1 every bit is as with 1; with -3 there is no cloud anywhere.
  test::noFaults("C05", "violations");
  const auto noiseOf = [](float value) {
    clouds::PackedCloudNoise noise = *test::plainNoise();
    std::ranges::fill(noise.base, value);
    std::ranges::fill(noise.weather, glm::vec3(value));
    return std::make_shared<const clouds::PackedCloudNoise>(std::move(noise));
  };
  clouds_ = test::plainSettings();
  addClouds(noiseOf(1));
  const std::vector<glm::vec4> all = cloudsFrom(inside());
  EXPECT_TRUE(meanOpacity(all) > 0.1 && meanOpacity(all) < 0.99);
  system_->apply(switchedOff(), wind_);
  addClouds(noiseOf(7));
  EXPECT_TRUE(cloudsFrom(inside()) == all);
  system_->apply(switchedOff(), wind_);
  addClouds(noiseOf(-3));
  EXPECT_EQ(system_->skipReason(gameFrame(snapshot_, inside(), features_)), "no cloud anywhere");
}

TEST_F(CloudRowsGLTest, C06_moreCoverageIsNotLessCloud) {
  // Neither from below nor from inside: the mean of 1 - T does not fall as the coverage grows from 0 to 1 and
  // beyond. Step by step: strides through clear air end elsewhere for each coverage.
  test::noFaults("C06", "violations");
  addClouds(test::sharedNoise());
  clouds_.march.clearStride = 0;
  for (const View& view : {below(), inside()}) {
    double before = 0;
    for (const double coverage : {0.1, 0.25, 0.4, 0.55, 0.7, 0.85, 1.0, 1.5}) {
      clouds_.layers[0].coverage = coverage;
      const double now = meanOpacity(cloudsFrom(view));
      EXPECT_GE(now, before) << coverage;
      before = now;
    }
    EXPECT_GT(before, 0.6);
  }
}

TEST_F(CloudRowsGLTest, C11_layerOfNoVisibleLengthShowsExactlyTheBackground) {
  // A surface below the layer, and one at its very base, leave nothing of it to be seen from below.
  test::noFaults("C11", "differences");
  addSky();
  addClouds(test::sharedNoise());
  addPlains();
  const View up = small({0, 600, 0}, 40, 60);
  EXPECT_GT(difference(sceneFrom(up), withoutClouds(up)), 20) << "no cloud in the picture";
  for (const double height : {700.0, 1500.0, 1555.0}) {
    plains_ = {{height, {0.2f, 0.3f, 0.1f}}};
    EXPECT_TRUE(sceneFrom(up) == withoutClouds(up)) << height;
  }
}

TEST_F(CloudRowsGLTest, C12_C16_marchedLengthIsThatOfTheRayToTheSurface) {
  // In a medium of one density the transmittance tells the length of each ray: centre, corners and all
  // between, in pictures of any size, within 1e-3 of what rayDirection() says. (A half float is cut by 1e-3
  // of the transmittance, at optical depths of 3 and more.)
  addClouds(test::plainNoise());
  clouds_ = test::plainSettings();
  clouds_.layers[0].thickness = 6000;  // of one density from 2530 m to 6835 m
  clouds_.layers[0].extinction = 0.003;
  clouds_.march.stepM = 200;  // exact in such a medium
  clouds_.march.transmittanceCutoff = 1e-5;
  plains_ = {{5200, {0.2f, 0.3f, 0.1f}}};
  addPlains();
  double worst = 0;
  for (const glm::ivec2& size : {glm::ivec2(64, 36), {1, 1}, {7, 5}, {801, 601}, {1920, 1080}}) {
    const View view = pose({200, 6400, -70}, 25, -62, 10, size.x, size.y);
    const std::vector<glm::vec4> rays = cloudsFrom(view);
    ASSERT_EQ(rays.size(), static_cast<std::size_t>(size.x * size.y));
    for (int y = 0; y < size.y; ++y) {
      for (int x = 0; x < size.x; ++x) {
        const double length =
            (plains_[0].heightM - view.position.y) / rayDirection(view, {x + 0.5, y + 0.5}).y;
        const float through = rays[static_cast<std::size_t>(y * size.x + x)].w;
        const double error = std::abs(-std::log(through) / clouds_.layers[0].extinction / length - 1);
        worst = std::max(worst, error);
        ASSERT_TRUE(test::holds("C12 C16", error, test::below(1e-3), "relative"))
            << x << ' ' << y << " of " << size.x << 'x' << size.y << ", length " << length;
      }
    }
  }
  RecordProperty("worst", std::to_string(worst));
}

TEST_F(CloudRowsGLTest, C13_skyIsMarchedWithoutRegardToThePlanes) {
  // There is no far plane. The near one may be moved from 0.1 m to 50 m: no pixel changes in a bit, and
  // clouds at 20 km are in the picture.
  test::noFaults("C13", "violations");
  addSky();
  addClouds(test::sharedNoise());
  View view = small({0, 600, 0}, 40, 5);
  const std::vector<glm::vec4> first = sceneFrom(view);
  for (const double nearM : {1.0, 50.0}) {
    view.nearM = nearM;
    EXPECT_TRUE(sceneFrom(view) == first) << nearM;
  }
  view.nearM = 0.1;
  clouds_.fadeDistance = 10000;
  EXPECT_GT(difference(sceneFrom(view), first), 2) << "no cloud was far away";
}

TEST_F(CloudRowsGLTest, C15_aStepInDepthIsAStepInLength) {
  // The edge of a plate above a plain, across pixels in many ways: every ray ends at one or at the other,
  // within 1e-3; none between them.
  test::noFaults("C15", "violations");
  addClouds(test::plainNoise());
  clouds_ = test::plainSettings();
  clouds_.layers[0].thickness = 6000;
  clouds_.layers[0].extinction = 0.003;
  clouds_.march.stepM = 200;
  clouds_.march.transmittanceCutoff = 1e-5;
  plains_ = {{5000, {0.2f, 0.3f, 0.1f}}};
  addPlains();
  renderer().add(
      std::make_unique<test::GroundPass>(context(), planeMesh(500, 400, 1, 1), glm::dvec3(0, 5400, 0)));
  const View view = pose({0, 6400, 0}, 25, -85, 17, kWidth, kHeight);
  const std::vector<glm::vec4> rays = cloudsFrom(view);
  int plate = 0, plain = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const double down = -rayDirection(view, {x + 0.5, y + 0.5}).y;
      const double depth = -std::log(rays[static_cast<std::size_t>(y * kWidth + x)].w);
      const double length = depth / clouds_.layers[0].extinction;
      const bool isPlate = std::abs(length * down / 1000 - 1) < 1e-3,
                 isPlain = std::abs(length * down / 1400 - 1) < 1e-3;
      plate += isPlate;
      plain += isPlain;
      ASSERT_TRUE(isPlate || isPlain) << x << ' ' << y << ": " << length;
    }
  }
  EXPECT_TRUE(plate > 100 && plain > 100) << plate << ' ' << plain;
}

// 0.6 makes 13 shapes a weather period of 52 km, and that is 130 periods of the detail: the field repeats as
// a whole.
constexpr double kWholePeriod = 52000;
void makeWhole(clouds::CloudSettings& clouds) {
  clouds.layers[0].scale = 0.6;
  clouds.layers[0].weatherScale = 0.02;
  clouds.layers[0].higherScale = 20;
  clouds.fadeDistance = 60000;
}

TEST_F(CloudRowsGLTest, C17_aFrameFarAwayIsTheSameFrameAtTheOrigin) {
  // Whole periods of the field away, at 1e9 m: within 1/255, at every resolution, towards the horizon too.
  addSky();
  addClouds(test::sharedNoise());
  makeWhole(clouds_);
  const double farAway = 1603 * 12 * kWholePeriod;  // 1e9 m
  ASSERT_EQ(std::fmod(farAway, clouds::weatherPeriod(clouds_.layers[0], clouds_.fadeDistance)), 0);
  ASSERT_EQ(std::fmod(farAway, clouds::detailPeriod(clouds_.layers[0])), 0);
  for (const auto tier : {clouds::CloudTier::low, clouds::CloudTier::high, clouds::CloudTier::ultra}) {
    clouds_.march = test::rowsOf(tier);
    for (View view : {below(), inside(), above(), small({0, 900, 0}, 40, 1)}) {
      const std::vector<glm::vec4> here = sceneFrom(view);
      view.position += glm::dvec3(farAway, 0, -farAway);
      const double apart = difference(here, sceneFrom(view));
      EXPECT_TRUE(test::holds("C17", apart, test::below(1), "of 255"));
      EXPECT_GT(difference(here, withoutClouds(view)), 20) << "no cloud in the picture";
    }
  }
}

TEST_F(CloudRowsGLTest, C18_aMonthOfWindCarriesTheFieldExactly) {
  // After 30 days of a west wind that makes 400 whole periods: within 1/255 of the first frame.
  addSky();
  addClouds(test::sharedNoise());
  makeWhole(clouds_);
  const double month = 30 * 86400;
  wind_.direction = 270;
  wind_.speed = 400 * kWholePeriod / month;
  const View view = small({1234.5, 600, -777.7}, 40, 14);
  const std::vector<glm::vec4> first = sceneFrom(view);
  snapshot_.simulatedSeconds = month;
  EXPECT_TRUE(test::holds("C18", difference(first, sceneFrom(view)), test::below(1), "of 255"));
  snapshot_.simulatedSeconds = month + 60;
  EXPECT_GT(difference(first, sceneFrom(view)), 5) << "the wind carries nothing";
}

TEST_F(CloudRowsGLTest, C20_crossingABoundaryIsNoJump) {
  // The eye on the layer's base and top, a millimetre above and a millimetre below, in every direction: with
  // a ray for each pixel less than 1/255 apart. At a quarter of the resolution a cell whose curvature is next
  // to the tolerance may be interpolated in one picture and marched in the other: an eighth of the tolerance,
  // what a parabola of that curvature differs from its chord by, in the worst pixel, and less than .1/255 in
  // the mean. Step by step: where strides through clear air begin depends on the cell that the eye is in, and
  // what they may miss is judged in tests/stability/clear_air_test.cpp.
  // With thin segments: where one ends a sample later, all of it is lit elsewhere, and by .01 each that
  // is 1.4/255 in single rays.
  addSky();
  addClouds(test::sharedNoise());
  clouds_.march.clearStride = clouds_.march.sunClearStride = 0;
  clouds_.march.lightOpacity = 0.002;
  const double most = 255 * clouds_.march.coarseTolerance / 8;
  for (const auto resolution : {clouds::MarchResolution::full, clouds::MarchResolution::quarter}) {
    clouds_.march.resolution = resolution;
    double worst = 0;
    const clouds::CloudLayerSettings& layer = clouds_.layers[0];
    for (const double boundary : {layer.cloudHeight, layer.cloudHeight + layer.thickness}) {
      for (const double pitch : {-80.0, -20.0, 0.0, 20.0, 80.0}) {
        const std::vector<glm::vec4> on = sceneFrom(small({500, boundary, 800}, 70, pitch));
        for (const double beside : {-1e-3, 1e-3}) {
          const std::vector<glm::vec4> next = sceneFrom(small({500, boundary + beside, 800}, 70, pitch));
          const double apart = difference(on, next);
          worst = std::max(worst, apart);
          const bool isWhole = resolution == clouds::MarchResolution::full;
          EXPECT_TRUE(test::holds("C20", apart, test::below(isWhole ? 1 : most), "of 255"))
              << boundary << ' ' << pitch << ' ' << beside;
          EXPECT_TRUE(test::holds("C20", meanDifference(on, next), test::below(0.1), "of 255"))
              << boundary << ' ' << pitch << ' ' << beside;
        }
      }
    }
    RecordProperty(resolution == clouds::MarchResolution::full ? "worstWhole" : "worstQuarter",
                   std::to_string(worst));
  }
}

TEST_F(CloudRowsGLTest, C21_sunAtTheZenithAndUnderTheHorizon) {
  // Straight up and down too, all is finite; under the horizon no light is direct: what the phase function
  // says of it makes no difference to any bit.
  test::noFaults("C21", "violations");
  addSky();
  addClouds(test::sharedNoise());
  const std::array views = {small({0, 600, 0}, 40, 90), small({0, 4500, 0}, 40, -90), inside()};
  const double middle = clouds_.layers[0].cloudHeight + 0.5 * clouds_.layers[0].thickness;
  const auto isDirect = [&](double elevation) {
    settings_.sun.elevationDegrees = elevation;
    return sky::sunIlluminance(skyLight(settings_, 0), middle).x > 0;
  };
  // Over a round earth clouds see the sun longer than the sea does.
  ASSERT_TRUE(isDirect(-0.3));
  settings_.sky.model = sky::SkyModel::closedForm;
  ASSERT_FALSE(isDirect(-0.3));
  settings_.sky.model = sky::SkyModel::shell;
  for (const double elevation : {90.0, 40.0, 0.0, -0.3, -10.0, -90.0}) {
    const bool direct = isDirect(elevation);
    for (const View& view : views) {
      clouds_.layers[0].anisotropy = 0;
      const std::vector<glm::vec4> even = cloudsFrom(view);
      ASSERT_TRUE(areFinite(even)) << elevation;
      clouds_.layers[0].anisotropy = 0.9;
      const std::vector<glm::vec4> onward = cloudsFrom(view);
      ASSERT_TRUE(areFinite(onward)) << elevation;
      EXPECT_EQ(even == onward, !direct) << elevation;
    }
  }
}

TEST_F(CloudRowsGLTest, C22_horizontalRaysInHazeAreNoSeam) {
  // The eye level in mist, in haze; an odd number of rows a twentieth of a degree apart, the middle one
  // exactly horizontal: neighbours differ by less than 1/255.
  features_.haze = true;
  settings_.atmosphere.visibilityM = 8000;
  settings_.camera.fovDegrees = 1;
  addSky();
  addClouds(test::plainNoise());
  clouds_ = test::plainSettings();
  clouds_.layers[0].extinction = 2e-4;
  const View view = pose({0, 2500, 0}, 30, 0, 0, 33, 21);
  ASSERT_EQ(rayDirection(view, {16.5, 10.5}).y, 0);
  const std::vector<glm::vec4> scene = sceneFrom(view);
  ASSERT_GT(system_->lastWork().tiles, 0u);
  const std::vector<glm::vec4> upper(scene.begin() + 33, scene.end()), lower(scene.begin(), scene.end() - 33);
  RecordProperty("worst", std::to_string(difference(upper, lower)));
  EXPECT_TRUE(test::holds("C22", difference(upper, lower), test::below(1), "of 255"));
}

TEST_F(CloudRowsGLTest, C25_aSunOfAHundredThousandStaysFinite) {
  // Exposed so that the sun lights clouds with 1e5 and the sky's disc is as bright as a half float can be:
  // all that is stored is finite, and transmittances are those of a dark frame.
  addSky();
  addClouds(test::sharedNoise());
  const glm::dvec3 toSun = directionToSun(settings_.sun);
  const View view = small({0, 600, 0}, settings_.sun.azimuthDegrees - 90, settings_.sun.elevationDegrees);
  EXPECT_GT(glm::dot(view.forward(), toSun), 0.999);
  clouds_.layers[0].coverage = 0.8;
  clouds_.layers[0].extinction = 0.001;
  const std::vector<glm::vec4> dark = cloudsFrom(view);
  settings_.exposureStops = 14;
  const std::vector<glm::vec4> bright = cloudsFrom(view);
  ASSERT_TRUE(areFinite(bright));
  for (std::size_t i = 0; i < dark.size(); ++i)
    ASSERT_TRUE(test::holds("C25", test::apart(dark[i].w, bright[i].w), test::atMost(1e-3), "transmittance"));
  // So is the sky's disc that comes through: each and together not more than a half float keeps.
  for (const std::vector<glm::vec4>& picture : {bright, sceneFrom(view)}) {
    float brightest = 0;
    for (const glm::vec4& light : picture) brightest = std::max({brightest, light.x, light.y, light.z});
    EXPECT_EQ(brightest, 60000.0f);
  }
}

}  // namespace
}  // namespace skydrop::render
