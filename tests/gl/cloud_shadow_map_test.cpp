// The shadows of clouds on what lies below them.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

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
  // From now on it shows what a slope of this unit normal receives.
  void lightSlope(const glm::dvec3& normal) { normal_ = normal; }
  // From now on the places count from an eye that is so much higher than the frame's.
  void countFromHigher(double riseM) { riseM_ = riseM; }

  std::string_view name() const override { return "shade"; }
  RenderStage stage() const override { return RenderStage::terrain; }
  void draw(FrameContext& context) override {
    const CloudShadowMap& map = context.resources.get<CloudShadowMap>();
    gl::Shader& shader = context.shaders.shader(
        "fullscreen.vert",
        test::sourceDir() + "/tests/gl/shaders/" + (normal_ ? "cloud_lit_slope.frag" : "cloud_shade.frag"),
        map.defines(map.hasSun()));
    shader.use();
    if (normal_) shader.setVec3("normal", glm::vec3(*normal_));
    shader.setVec3("corner", relativeToEye(context.frame.view, corner_ - glm::dvec3(0, riseM_, 0)));
    shader.setFloat("spacing", spacing_);
    map.bind(shader, riseM_);
    context.gl.api().Disable(GL_DEPTH_TEST);
    triangle_.draw();
  }

 private:
  FullscreenTriangle triangle_;
  glm::dvec3 corner_;
  float spacing_;
  std::optional<glm::dvec3> normal_;
  double riseM_ = 0;
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
    double largest = 0, square = 0, straightSquare = 0, least = 1;
    for (int y = 0; y < 45; ++y) {
      for (int x = 0; x < 80; ++x) {
        const glm::vec4& there = light[static_cast<std::size_t>(y * 80 + x)];
        const LightShares shares = system_->lightAt(corner + glm::dvec3(x, 0, y) * double{kSpacing}, frame);
        largest = std::max(largest, std::abs(static_cast<double>(there.y) - shares.sky));
        const double sun = shares.sun + shares.diffuseSun;
        square += std::pow(static_cast<double>(there.x) - sun, 2) / (80 * 45);
        straightSquare += std::pow(static_cast<double>(there.z) - shares.sun, 2) / (80 * 45);
        least = std::min({least, sun, shares.sky});
      }
    }
    EXPECT_LT(largest, 0.005) << height;
    if (height == 0) {
      RecordProperty("sunRms", std::to_string(std::sqrt(square)));
      EXPECT_LT(std::sqrt(square), 0.08);
      // Without the part that changes slowly, steps at edges weigh 1 / .65 as much.
      RecordProperty("straightRms", std::to_string(std::sqrt(straightSquare)));
      EXPECT_LT(std::sqrt(straightSquare), 0.08 / 0.65);
    }
    if (height < base + thickness) {
      EXPECT_LT(least, 0.7) << height;
    } else {
      EXPECT_EQ(least, 1);
    }
  }
}

TEST_F(CloudShadowMapGLTest, anEyeBelowSeesTheSameShade) {
  // Places that count from an eye 600 m lower, as those of a mirrored view do, are in the same shade: within
  // 1/500 of the light, by the rounding of float places of a kilometre. Within the fine grid and the layer.
  settings_.sun.elevationDegrees = 40;
  addClouds(test::sharedNoise());
  renderer().add(std::make_unique<CloudShadowPass>(*system_));
  const double base = clouds_.layers[0].cloudHeight, thickness = clouds_.layers[0].thickness;
  for (const double height : {0.0, base + 0.4 * thickness}) {
    auto pass = std::make_unique<ShadeOfASquare>(context(), glm::dvec3(-800, height, -450), 20.0f);
    ShadeOfASquare& places = *pass;
    renderer().add(std::move(pass));
    const View view = pose({0, 300, 0}, 0, -90, 0, 80, 45);
    const std::vector<glm::vec4> above = sceneFrom(view);
    places.countFromHigher(-600);
    const std::vector<glm::vec4> below = sceneFrom(view);
    float least = 1, largest = 0;
    for (std::size_t i = 0; i < above.size(); ++i) {
      least = std::min(least, above[i].x);
      for (int part = 0; part < 3; ++part)
        largest = std::max(largest, std::abs(above[i][part] - below[i][part]));
    }
    EXPECT_LT(largest, 0.002f) << height;
    EXPECT_LT(least, 0.7f) << height;
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

TEST_F(CloudShadowMapGLTest, underAThickDeckLightComesFromAllOfTheSky) {
  // Below an even deck of optical depth over 15, slopes of 40 degrees towards the sun and away from it
  // receive the same, where in the open the one has over four times the light of the other; the slope away is
  // not bluer than level ground, where in the open its light is that of the blue sky alone. Level ground
  // receives the shares of sun and sky that it would if all came straight from the sun.
  settings_.sun = {40, 90};
  const double tilt = glm::radians(40.0);
  const glm::dvec3 towards(std::sin(tilt), std::cos(tilt), 0), away(-towards.x, towards.y, 0);
  const View view = pose({0, 300, 0}, 0, -90, 0, 8, 8);
  clouds_ = test::plainSettings();
  clouds_.layers[0].extinction = 0.05;
  addClouds(test::plainNoise());
  renderer().add(std::make_unique<CloudShadowPass>(*system_));
  auto pass = std::make_unique<ShadeOfASquare>(context(), glm::dvec3(-40, 0, -40), 10.0f);
  ShadeOfASquare& slope = *pass;
  renderer().add(std::move(pass));
  const auto mean = [&] {
    glm::dvec3 sum(0);
    const std::vector<glm::vec4> light = sceneFrom(view);
    for (const glm::vec4& there : light) sum += glm::dvec3(there) / static_cast<double>(light.size());
    return sum;
  };
  const auto on = [&](const glm::dvec3& normal) {
    slope.lightSlope(normal);
    return mean();
  };
  const auto blueOverRed = [](const glm::dvec3& light) { return light.z / light.x; };

  const glm::dvec3 shares = mean();
  const glm::dvec3 level = on({0, 1, 0}), lit = on(towards), dark = on(away);
  EXPECT_LT(shares.z, 1e-6) << "straight from the sun";
  EXPECT_NEAR(lit.y / dark.y, 1, 0.01);
  EXPECT_NEAR(blueOverRed(dark) / blueOverRed(level), 1, 0.05);
  RecordProperty("blueOverRedOfTheSlopeAway", std::to_string(blueOverRed(dark)));

  clouds_.layers[0].extinction = 1e-7;  // as good as none
  system_->apply(clouds_, wind_);
  const glm::dvec3 openLevel = on({0, 1, 0}), openLit = on(towards), openDark = on(away);
  EXPECT_GT(openLit.y / openDark.y, 4);
  EXPECT_GT(blueOverRed(openDark) / blueOverRed(openLevel), 1.5);
  const SkyLight sky = skyLight(settings_, 300);
  const glm::dvec3 ofSky = openLevel - sky.direct.sun * sky.direct.toSun.y * sky.exposure;
  const glm::dvec3 expected = (openLevel - ofSky) * shares.x + ofSky * shares.y;
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_NEAR(level[channel] / expected[channel], 1, 0.01) << channel;
  }
}

}  // namespace
}  // namespace skydrop::render
