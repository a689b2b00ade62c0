// What mountains take from the sun on clouds without thickness: against the shade on the processor, where
// they take nothing, and when nothing is done.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "skydrop/render/clouds/cloud_dome.h"
#include "skydrop/render/clouds/cloud_plane.h"
#include "skydrop/render/shadows/land_shadow_pass.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "support/cloud_rows.h"

namespace skydrop::render {
namespace {

using Light = std::vector<glm::vec4>;

constexpr double kPlaneM = 700;

// Behind a ridge along z that hides the sun in the east.
class SheetLandShadeGLTest : public test::CloudRowsGLTest {
 protected:
  void SetUp() override {
    CloudRowsGLTest::SetUp();
    if (IsSkipped()) return;
    renderer().add(std::make_unique<test::LightProbe>(light_));
    addSky();
    settings_.sun = {6, 90};
    features_ = {.haze = false, .landShadows = true};
  }
  void addRidge(double crestM) { addLand(terrain::makeRidgeSource(0, crestM, 3, 0)); }
  // Level in the west, and rising to a plateau in the east.
  void addPlateau(double heightM) { addLand(terrain::makeTiltedPlaneSource(0, {1, 0}, {0, heightM})); }
  void addLand(std::shared_ptr<const terrain::HeightSource> source) {
    auto pass = std::make_unique<LandShadowPass>(std::move(source), LandShadowSettings{});
    land_ = pass.get();
    renderer().setGroup({"land"});
    renderer().add(std::move(pass));
    renderer().setGroup({});
  }
  void addPlanes() {
    for (clouds::CloudPlaneSettings& layer : planes_.layers) layer.textureSide = 256;
    planes_.count = 1;
    planes_.layers[0].height = kPlaneM;
    planes_.layers[0].cutoff = 0.2;
    auto pass = std::make_unique<CloudPlanes>(context(), nullptr, planes_, wind_);
    pass_ = pass.get();
    renderer().add(std::move(pass));
  }
  // Straight down on the plane, x metres east of the ridge.
  View above(double x) const { return small({x, 3000, 0}, 0, -90); }
  // With the effect landShadows or without. From above, selfShadow is how the sun's light fades in the sheet.
  Light planes(const View& view, double selfShadow, bool shaded = true) {
    planes_.selfShadow = selfShadow;
    pass_->apply(planes_, wind_);
    pass_->waitForNoise();
    features_.landShadows = shaded;
    draw(view);
    features_.landShadows = true;
    return light_;
  }
  std::int64_t textures() {
    return static_cast<std::int64_t>(context().resources().live(gl::ObjectKind::texture));
  }

  clouds::CloudPlanesSettings planes_;
  CloudPlanes* pass_ = nullptr;
  LandShadowPass* land_ = nullptr;
  Light light_;
};

TEST_F(SheetLandShadeGLTest, aPlaneInTheUmbraHasNothingOfTheSun) {
  // How its light fades in the sheet changes no bit there, though it changes the plane without the shade, in
  // full resolution and with fewer pixels.
  addRidge(1500);
  addPlanes();
  const View view = above(-2500);
  for (const auto resolution : {clouds::SheetResolution::full, clouds::SheetResolution::quarter}) {
    planes_.resolution = resolution;
    EXPECT_EQ(planes(view, 0.2), planes(view, 2));
    EXPECT_NE(planes(view, 0.2, false), planes(view, 2, false));
  }
}

TEST_F(SheetLandShadeGLTest, theEdgeOnAPlaneIsThatOnTheProcessor) {
  // What the fading of the sun's light changes, with the shade against without, is the share of the disc over
  // the land at the place: within 0.01 in the mean and 0.1 everywhere (half floats).
  addRidge(1500);
  addPlanes();
  planes_.resolution = clouds::SheetResolution::full;
  const double end = -(1500 - kPlaneM) / std::tan(glm::radians(6.0));
  const View view = above(end);
  const Light bright = planes(view, 0.1), dim = planes(view, 3);
  const Light brightLit = planes(view, 0.1, false), dimLit = planes(view, 3, false);
  double worst = 0, sum = 0, least = 1, most = 0;
  for (int y = 0; y < test::kCloudRowsHeight; ++y) {
    for (int x = 0; x < test::kCloudRowsWidth; ++x) {
      const auto i = static_cast<std::size_t>(y * test::kCloudRowsWidth + x);
      const glm::dvec3 ray = rayDirection(view, {x + 0.5, y + 0.5});
      const glm::dvec3 place = view.position + ray * ((kPlaneM - view.position.y) / ray.y);
      const double share = static_cast<double>((bright[i].y - dim[i].y) / (brightLit[i].y - dimLit[i].y));
      const double error = share - land_->shade()->sunShare(place);
      worst = std::max(worst, std::abs(error));
      sum += error / static_cast<double>(bright.size());
      least = std::min(least, share), most = std::max(most, share);
    }
  }
  RecordProperty("worst", std::to_string(worst));
  RecordProperty("mean", std::to_string(sum));
  EXPECT_TRUE(least < 0.1 && most > 0.9) << "the edge is in the picture";
  EXPECT_LT(worst, 0.1);
  EXPECT_LT(std::abs(sum), 0.01);
}

TEST_F(SheetLandShadeGLTest, onTheSunsSideEveryBitIsThatOfAFrameWithoutIt) {
  addRidge(1500);
  addPlanes();
  EXPECT_EQ(planes(above(2500), 1), planes(above(2500), 1, false));
}

TEST_F(SheetLandShadeGLTest, aPlaneAboveTheSummitsAndAHighSunHaveNoShade) {
  // Nor does the pass then keep a texture of it, and no program is made when the sun sinks.
  addRidge(1500);
  addPlanes();
  const View view = above(-2500);
  planes_.layers[0].height = 1510;
  settings_.sun = {80, 90};
  planes(view, 1);
  const std::int64_t idle = textures();
  drawFollowing(view);
  const std::uint64_t made = renderer().shaders().madeSoFar();
  settings_.sun = {6, 90};
  const Light low = planes(view, 1);
  EXPECT_EQ(textures(), idle + 1) << "the shade on land alone";
  EXPECT_EQ(low, planes(view, 1, false));
  planes_.layers[0].height = kPlaneM;
  const Light shaded = planes(view, 1);
  EXPECT_EQ(textures(), idle + 2);
  EXPECT_EQ(renderer().shaders().madeSoFar(), made);
  EXPECT_NE(shaded, planes(view, 1, false));
}

TEST_F(SheetLandShadeGLTest, theShadeOnPlanesIsGoneWhenTheSunIs) {
  // The share that counts fades with the setting sun, so the last shade is no darker than none: by eye within
  // half a step of 255.
  addRidge(1500);
  addPlanes();
  const View view = above(-2500);
  settings_.sun = {-0.25, 90};
  EXPECT_LT(difference(planes(view, 1), planes(view, 1, false)), 0.5);
  settings_.sun = {1.2, 90};
  EXPECT_GT(difference(planes(view, 1), planes(view, 1, false)), 5);
}

TEST_F(SheetLandShadeGLTest, theDomeIsShadedByMountainsThatAreHigherAlone) {
  // It lies 7 km up: below that every bit is that of a frame without the shade and there is no texture of it;
  // behind a ridge of 9 km it is darker.
  addRidge(6900);
  clouds::CloudDomeSettings dome;
  dome.textureSide = 64;
  dome.cutoff = 0.3;
  auto pass = std::make_unique<CloudDome>(context(), nullptr, dome);
  CloudDome& drawn = *pass;
  renderer().add(std::move(pass));
  drawn.waitForNoise();
  const View view = small({-2000, 500, 0}, 180, 60);
  const auto frame = [&](bool shaded) {
    features_.landShadows = shaded;
    draw(view);
    return light_;
  };
  const Light below = frame(true);
  const std::int64_t idle = textures();
  EXPECT_EQ(below, frame(false));
  renderer().removeGroup("land");
  addPlateau(9200);
  const Light dark = frame(true);
  EXPECT_GT(textures(), idle);
  const Light lit = frame(false);
  EXPECT_EQ(textures(), idle);
  EXPECT_GT(difference(dark, lit), 3);
  double sum = 0;
  for (std::size_t i = 0; i < dark.size(); ++i) sum += static_cast<double>(lit[i].y - dark[i].y);
  EXPECT_GT(sum, 0);
}

}  // namespace
}  // namespace skydrop::render
