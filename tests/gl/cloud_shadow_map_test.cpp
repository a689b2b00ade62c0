// The shadows of clouds on what lies below them.
#include <algorithm>
#include <cmath>
#include <memory>

#include "skydrop/render/clouds/cloud_shade_pass.h"
#include "skydrop/render/frame/fullscreen_triangle.h"
#include "skydrop/render/frame/sky_light.h"
#include "support/cloud_frame_test.h"
#include "support/paths.h"
#include "support/shared_noise.h"

namespace skydrop::render {
namespace {

// Fills the scene with the shade of places that stay where they are while the eye moves.
class ShadeOfASquare final : public Pass {
 public:
  ShadeOfASquare(gl::Context& context, const glm::dvec3& corner, float spacing)
      : triangle_(context), corner_(corner), spacing_(spacing) {}

  void moveTo(const glm::dvec3& corner) { corner_ = corner; }

  std::string_view name() const override { return "shade"; }
  RenderStage stage() const override { return RenderStage::terrain; }
  void draw(FrameContext& context) override {
    const CloudShadowMap& map = context.resources.get<CloudShadowMap>();
    gl::Shader& shader =
        context.shaders.shader("fullscreen.vert", test::sourceDir() + "/tests/gl/shaders/cloud_shade.frag",
                               map.defines(map.hasSun()));
    shader.use();
    shader.setVec3("corner", relativeToEye(context.frame.view, corner_));
    shader.setFloat("spacing", spacing_);
    map.bind(shader);
    context.gl.api().Disable(GL_DEPTH_TEST);
    triangle_.draw();
  }

 private:
  FullscreenTriangle triangle_;
  glm::dvec3 corner_;
  float spacing_;
};

using CloudShadowMapGLTest = test::CloudFrameTest;

TEST_F(CloudShadowMapGLTest, shadowsStayWhereTheGridsMove) {
  // The eye flies 500 m across the sun's azimuth in steps of 4 m, so that the fine grid, which moves in steps
  // of 480 m, moves at least once. What the clouds leave of the sun at 160 x 90 places out to 12 km changes
  // only by the fading between the grids: by less than 1 % of what they differ by in depth (4 m of 720 m,
  // times the steepest slope of smoothstep, 1.5), below 0.1 of the sun where the depths are apart by 10.
  // Where the fading moved with the grid, it changed by most of the difference at once.
  settings_.sun.azimuthDegrees = 90;
  addClouds(test::sharedNoise());
  renderer().add(std::make_unique<CloudShadowPass>(*system_));
  constexpr float kSpacing = 150;
  renderer().add(std::make_unique<ShadeOfASquare>(context(), glm::dvec3(-12000, 0, -6750), kSpacing));
  std::vector<glm::vec4> before;
  double shade = 1;
  for (int step = 0; step <= 125; ++step) {
    const glm::dvec3 eye(1000, 300, 4 * step);
    const std::vector<glm::vec4> now = sceneFrom(pose(eye, 0, -90, 0, 160, 90));
    double largest = 0, skyLargest = 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
      shade = std::min(shade, static_cast<double>(now[i].x));
      if (!before.empty()) largest = std::max(largest, std::abs(static_cast<double>(now[i].x - before[i].x)));
      if (!before.empty()) {
        skyLargest = std::max(skyLargest, std::abs(static_cast<double>(now[i].y - before[i].y)));
      }
    }
    ASSERT_LT(largest, 0.1) << "step " << step;
    // The sky's map stays where it is, but for its rounding: 1/256 of the difference of two texels.
    ASSERT_LT(skyLargest, 0.005) << "step " << step;
    before = now;
  }
  EXPECT_LT(shade, 0.7) << "no shadow in the square";
}

TEST_F(CloudShadowMapGLTest, surfacesAndModelsAreInTheSameShade) {
  // At 80 x 45 places below, within and above the layer. Of the sky: the same map, within the filter's 1/256
  // of the difference of two texels. Of the sun, below the layer: a grid of columns 60 m apart against one
  // march a place, .08 RMS in the default clouds.
  settings_.sun.elevationDegrees = 40;
  addClouds(test::sharedNoise());
  renderer().add(std::make_unique<CloudShadowPass>(*system_));
  constexpr float kSpacing = 90;
  auto pass = std::make_unique<ShadeOfASquare>(context(), glm::dvec3(0), kSpacing);
  ShadeOfASquare& places = *pass;
  renderer().add(std::move(pass));
  const double base = clouds_.layers[0].cloudHeight, thickness = clouds_.layers[0].thickness;
  for (const double height : {0.0, base + 0.4 * thickness, base + thickness + 10}) {
    const glm::dvec3 corner(-3600, height, -2000);
    places.moveTo(corner);
    const View view = pose({0, 300, 0}, 0, -90, 0, 80, 45);
    const std::vector<glm::vec4> light = sceneFrom(view);
    FrameInput frame = gameFrame(snapshot_, view, features_);
    frame.toSun = directionToSun(settings_.sun);
    double largest = 0, square = 0, least = 1;
    for (int y = 0; y < 45; ++y) {
      for (int x = 0; x < 80; ++x) {
        const glm::vec4& there = light[static_cast<std::size_t>(y * 80 + x)];
        const LightShares shares = system_->lightAt(corner + glm::dvec3(x, 0, y) * double{kSpacing}, frame);
        largest = std::max(largest, std::abs(static_cast<double>(there.y) - shares.sky));
        square += std::pow(static_cast<double>(there.x) - shares.sun, 2) / (80 * 45);
        least = std::min({least, shares.sun, shares.sky});
      }
    }
    EXPECT_LT(largest, 0.005) << height;
    if (height == 0) {
      RecordProperty("sunRms", std::to_string(std::sqrt(square)));
      EXPECT_LT(std::sqrt(square), 0.08);
    }
    if (height < base + thickness) {
      EXPECT_LT(least, 0.7) << height;
    } else {
      EXPECT_EQ(least, 1);
    }
  }
}

TEST_F(CloudShadowMapGLTest, theSkyStaysDimWhenTheSunSets) {
  // From just above the horizon to just below it the light of the sky that is left does not change, no grid
  // is filled at night, and the programs of both are there before.
  addClouds(test::sharedNoise());
  renderer().add(std::make_unique<CloudShadowPass>(*system_));
  renderer().add(std::make_unique<ShadeOfASquare>(context(), glm::dvec3(-6000, 0, -3000), 150.0f));
  const View view = pose({0, 300, 0}, 0, -90, 0, 80, 45);
  settings_.sun.elevationDegrees = 0.01;
  const std::vector<glm::vec4> day = sceneFrom(view);
  settings_.sun.elevationDegrees = -0.01;
  EXPECT_TRUE(context().resources().passes().contains("cloudShadows"));
  const std::vector<glm::vec4> night = sceneFrom(view);
  EXPECT_FALSE(context().resources().passes().contains("cloudShadows")) << "draws or dispatches at night";
  float least = 1;
  for (std::size_t i = 0; i < day.size(); ++i) {
    ASSERT_EQ(day[i].y, night[i].y);
    ASSERT_EQ(night[i].x, 1);
    least = std::min(least, night[i].y);
  }
  EXPECT_LT(least, 0.8f);
}

}  // namespace
}  // namespace skydrop::render
