// What mountains take from the sun in a layer of clouds: against the shade on the processor, where they take
// nothing, and when nothing is done.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <memory>
#include <vector>

#include "skydrop/render/frame/sky_light.h"
#include "skydrop/render/shadows/land_shadow_pass.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "support/cloud_frame_test.h"

namespace skydrop::render {
namespace {

using Light = std::vector<glm::vec4>;

constexpr int kWidth = 64, kHeight = 36;
constexpr double kCrestM = 1500, kBaseM = 400, kThicknessM = 300;

// An even deck behind a ridge along z that hides the sun in the east.
class CloudLandShadeGLTest : public test::CloudFrameTest {
 protected:
  void SetUp() override {
    CloudFrameTest::SetUp();
    if (IsSkipped()) return;
    auto pass =
        std::make_unique<LandShadowPass>(terrain::makeRidgeSource(0, kCrestM, 3, 0), LandShadowSettings{});
    land_ = pass.get();
    renderer().add(std::move(pass));
    clouds_ = test::plainSettings();
    clouds_.layers[0].cloudHeight = kBaseM;
    clouds_.layers[0].thickness = kThicknessM;
    clouds_.layers[0].extinction = 0.05;
    addClouds(test::plainNoise());
    settings_.sun = {6, 90};
    features_.landShadows = true;
  }
  // Straight down on the deck, x metres east of the ridge.
  View above(double x) const { return pose({x, 4000, 0}, 0, -90, 0, kWidth, kHeight); }
  // As cloudsFrom(), with the effect landShadows or without.
  Light clouds(const View& view, bool shaded = true) {
    features_.landShadows = shaded;
    Light light = cloudsFrom(view);
    features_.landShadows = true;
    return light;
  }

  LandShadowPass* land_ = nullptr;
};

TEST_F(CloudLandShadeGLTest, inTheUmbraNothingOfTheSunIsLeft) {
  // The light of clouds that a ridge hides from the sun is that of sky and ground alone: how clouds scatter
  // sunlight changes no bit of it, though it changes the deck without the ridge's shade.
  for (const auto& march : {test::quickRows(), test::quickExactRows()}) {
    clouds_.march = march;
    const View view = above(-2500);  // the shade of the crest ends at 9 km behind it
    const Light dark = clouds(view), lit = clouds(view, false);
    clouds_.layers[0].anisotropy = 0.7;
    const Light darkForward = clouds(view), litForward = clouds(view, false);
    EXPECT_EQ(dark, darkForward);
    EXPECT_NE(lit, litForward);
    double share = 0;
    for (std::size_t i = 0; i < dark.size(); ++i) {
      ASSERT_GT(dark[i].y, 0) << i;
      ASSERT_EQ(dark[i].w, lit[i].w) << i;
      share += static_cast<double>(dark[i].y / lit[i].y) / static_cast<double>(dark.size());
    }
    EXPECT_LT(share, 0.8);
    clouds_.layers[0].anisotropy = 0.119;
  }
}

TEST_F(CloudLandShadeGLTest, theShadowOnADeckEndsWhereThatOnTheProcessorDoes) {
  // Straight down on the top of a thick deck: the sun's light that is left is the share at the place where
  // the ray's light comes from, in the mean within 0.01. Single rays differ by up to 0.16 (their segments lie
  // at several heights, and the top's light is stored in half floats).
  clouds_.layers[0].extinction = 0.5;
  const double end = -(kCrestM - kBaseM - kThicknessM) / std::tan(glm::radians(6.0));
  const View view = above(end);
  const Light lit = clouds(view, false);
  const Light dark = clouds(above(-2500)), darkLit = clouds(above(-2500), false);
  const auto middle = static_cast<std::size_t>(kWidth * kHeight / 2 + kWidth / 2);
  const double ofSky = static_cast<double>(dark[middle].y / darkLit[middle].y);
  const Light half = clouds(view);
  std::vector<float> distances(half.size());
  system_->rays()[0].distances.read(GL_RED, GL_FLOAT, std::as_writable_bytes(std::span(distances)));
  double worst = 0, sum = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const auto i = static_cast<std::size_t>(y * kWidth + x);
      const glm::dvec3 place =
          view.position + rayDirection(view, {x + 0.5, y + 0.5}) * static_cast<double>(distances[i]);
      const double share = (static_cast<double>(half[i].y / lit[i].y) - ofSky) / (1 - ofSky);
      const double error = share - land_->shade()->sunShare(place);
      worst = std::max(worst, std::abs(error));
      sum += error / static_cast<double>(half.size());
    }
  }
  RecordProperty("worst", std::to_string(worst));
  RecordProperty("mean", std::to_string(sum));
  const auto [least, most] = std::ranges::minmax_element(half, {}, [](const glm::vec4& t) { return t.y; });
  EXPECT_GT(most->y, 1.2f * least->y) << "the edge is in the picture";
  EXPECT_LT(worst, 0.2);
  EXPECT_LT(std::abs(sum), 0.01);
}

TEST_F(CloudLandShadeGLTest, onTheSunsSideEveryBitIsThatOfAFrameWithoutIt) {
  for (const auto& march : {test::quickRows(), test::quickExactRows()}) {
    clouds_.march = march;
    EXPECT_EQ(clouds(above(2500)), clouds(above(2500), false));
  }
}

TEST_F(CloudLandShadeGLTest, aLayerAboveTheSummitsAndAHighSunHaveNoShade) {
  // Nor does the pass then keep a texture of the shade, and no program is made when the sun sinks.
  const View view = above(-2500);
  const auto textures = [&] { return context().resources().live(gl::ObjectKind::texture); };
  clouds_.layers[0].cloudHeight = kCrestM + 10;
  settings_.sun = {80, 90};
  const Light high = clouds(view);
  const auto idle = textures();
  drawFollowing(view);
  const std::uint64_t made = renderer().shaders().madeSoFar();
  settings_.sun = {6, 90};
  const Light low = clouds(view);
  EXPECT_EQ(textures(), idle + 1) << "the shade on land alone";
  EXPECT_EQ(low, clouds(view, false));
  clouds_.layers[0].cloudHeight = kBaseM;
  clouds(view);
  EXPECT_EQ(textures(), idle + 2);
  EXPECT_EQ(renderer().shaders().madeSoFar(), made);
  EXPECT_NE(high, low);
}

}  // namespace
}  // namespace skydrop::render
