// The shadows of clouds on what lies below them.
#include <algorithm>
#include <cmath>
#include <memory>

#include "skydrop/render/frame/fullscreen_triangle.h"
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

  std::string_view name() const override { return "shade"; }
  RenderStage stage() const override { return RenderStage::terrain; }
  void draw(FrameContext& context) override {
    gl::Shader& shader =
        context.shaders.shader("fullscreen.vert", test::sourceDir() + "/tests/gl/shaders/cloud_shade.frag");
    shader.use();
    shader.setVec3("corner", relativeToEye(context.frame.view, corner_));
    shader.setFloat("spacing", spacing_);
    context.resources.get<CloudShadowMap>().bind(shader);
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
    double largest = 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
      shade = std::min(shade, static_cast<double>(now[i].x));
      if (!before.empty()) largest = std::max(largest, std::abs(static_cast<double>(now[i].x - before[i].x)));
    }
    ASSERT_LT(largest, 0.1) << "step " << step;
    before = now;
  }
  EXPECT_LT(shade, 0.7) << "no shadow in the square";
}

}  // namespace
}  // namespace skydrop::render
