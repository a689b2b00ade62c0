// EGL and OSMesa in one process.
#include <bit>
#include <glm/gtc/matrix_transform.hpp>

#include "skydrop/render/clouds/cloud_system.h"
#include "skydrop/render/frame/renderer.h"
#include "skydrop/render/gl/pass_timer.h"
#include "skydrop/render/gl/shader.h"
#include "skydrop/render/models/mesh.h"
#include "skydrop/render/sky/sky_pass.h"
#include "support/gl_test.h"
#include "support/light_probe.h"
#include "support/margin.h"
#include "support/shared_noise.h"
#include "support/temporary_folder.h"

namespace skydrop::render {
namespace {

constexpr int kWidth = 160, kHeight = 90;

// A lit sphere in a torus over a plane, with depth: vertices, interpolation, textures of depth,
// transcendental functions.
std::vector<glm::vec4> drawScene(gl::Context& context, const test::TemporaryFolder& folder) {
  gl::Shader shader(context, folder.write("scene.vert", R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 viewProjection;
out vec3 n;
out vec3 p;
void main() { n = normal; p = position; gl_Position = viewProjection * vec4(position, 1.0); }
)"),
                    folder.write("scene.frag", R"(
in vec3 n;
in vec3 p;
out vec4 color;
void main() {
  vec3 unit = normalize(n);
  float lit = max(dot(unit, normalize(vec3(1.0, 2.0, 3.0))), 0.0);
  color = vec4(exp(-length(p)) + pow(lit, 3.0), sin(10.0 * p.x) * 0.5 + 0.5, lit, 1.0);
}
)"));
  Mesh sphere(context, sphereMesh(0.5, 24, 16), "sphere");
  Mesh torus(context, torusMesh(1.0, 0.2, 32, 12), "torus");
  Mesh plane(context, planeMesh(4, 4, 4, 4), "plane");
  gl::FrameBuffer target(context, kWidth, kHeight, {}, "target");
  target.bind();
  const glm::mat4 view = glm::lookAt(glm::vec3(1, 2, 3), glm::vec3(0), glm::vec3(0, 1, 0));
  glm::mat4 projection(0);  // reversed depth, infinite far plane, 60 degrees, near plane at 0.1
  const float focal = 1.7320508f;
  projection[0][0] = focal * kHeight / kWidth;
  projection[1][1] = focal;
  projection[2][3] = -1;
  projection[3][2] = 0.1f;
  shader.use();
  shader.setMatrix("viewProjection", projection * view);
  sphere.draw();
  torus.draw();
  plane.draw();
  target.unBind();
  return test::readFloats(target);
}

TEST(Backends, eglAndOsMesaDrawTheSameBitsInOneProcess) {
  // The scene is drawn on one back-end, on the other, and again on the first while both live: all bits agree.
  std::string why;
  const auto egl = test::openForTest(gl::Backend::egl, why);
  if (!egl) GTEST_SKIP() << why;
  const auto osmesa = test::openForTest(gl::Backend::osmesa, why);
  if (!osmesa) GTEST_SKIP() << why;
  const test::TemporaryFolder folder;

  egl->makeCurrent();
  const std::vector<glm::vec4> first = drawScene(*egl, folder);
  osmesa->makeCurrent();
  const std::vector<glm::vec4> second = drawScene(*osmesa, folder);
  egl->makeCurrent();
  const std::vector<glm::vec4> third = drawScene(*egl, folder);

  ASSERT_EQ(first.size(), second.size());
  int different = 0, covered = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    covered += first[i].w > 0;
    for (int c = 0; c < 4; ++c) {
      different += std::bit_cast<std::uint32_t>(first[i][c]) != std::bit_cast<std::uint32_t>(second[i][c]);
      different += std::bit_cast<std::uint32_t>(first[i][c]) != std::bit_cast<std::uint32_t>(third[i][c]);
    }
  }
  EXPECT_EQ(different, 0);
  EXPECT_GT(covered, kWidth * kHeight / 4);  // the scene is in the picture
  for (const auto* context : {egl.get(), osmesa.get()}) {
    EXPECT_EQ(context->debugErrors(), 0u);
    EXPECT_EQ(context->resources().liveObjects(), 0);
    EXPECT_EQ(context->resources().bytes(), 0u);
  }
  EXPECT_EQ(osmesa->resources().total().draws, 3u);
}

// Clouds before the sky, from below: by the defaults, or by the exact march.
std::vector<glm::vec4> drawClouds(gl::Context& context, bool exact) {
  const RenderSettings settings;
  std::vector<glm::vec4> light;
  Renderer renderer(context, settings, false);
  clouds::CloudSettings clouds;
  clouds.march.exact = exact;
  renderer.add(std::make_unique<SkyPass>(context));
  renderer.add(std::make_unique<CloudSystem>(context, test::sharedNoise(), clouds, core::WindSettings{}));
  renderer.add(std::make_unique<test::LightProbe>(light));
  View view;
  view.position = {0, 600, 0};
  view.worldToView = glm::transpose(glm::dmat3(glm::rotate(glm::dmat4(1), glm::radians(15.0), {1, 0, 0})));
  view.width = kWidth;
  view.height = kHeight;
  renderer.draw({.view = view, .features = {.haze = true}});
  return light;
}

TEST(Backends, C10_eglAndOsMesaDrawTheSameClouds) {
  // In one process, by either march: all bits agree.
  test::noFaults("C10", "differences");
  std::string why;
  const auto egl = test::openForTest(gl::Backend::egl, why);
  if (!egl) GTEST_SKIP() << why;
  const auto osmesa = test::openForTest(gl::Backend::osmesa, why);
  if (!osmesa) GTEST_SKIP() << why;
  for (const bool exact : {false, true}) {
    egl->makeCurrent();
    const std::vector<glm::vec4> first = drawClouds(*egl, exact);
    osmesa->makeCurrent();
    const std::vector<glm::vec4> second = drawClouds(*osmesa, exact);
    ASSERT_EQ(first.size(), static_cast<std::size_t>(kWidth * kHeight));
    EXPECT_TRUE(first == second) << exact;
  }
}

using MeshGLTest = test::GLTest;

TEST_F(MeshGLTest, nearerSurfacesWinWhateverTheOrder) {
  // Reversed depth with GEQUAL: the sphere hides the plane behind it in both orders of drawing.
  const test::TemporaryFolder folder;
  gl::Shader shader(
      context(), folder.write("flat.vert", R"(
layout(location = 0) in vec3 position;
uniform float depth;
void main() { gl_Position = vec4(position.xy, depth, 1.0); }
)"),
      folder.write("flat.frag", "uniform vec4 tint;\nout vec4 color;\nvoid main() { color = tint; }\n"));
  Mesh mesh(context(), sphereMesh(1, 16, 8), "sphere");
  gl::FrameBuffer target(context(), 8, 8, {}, "target");
  for (const bool nearFirst : {true, false}) {
    target.bind();
    shader.use();
    for (const bool isNear : {nearFirst, !nearFirst}) {
      shader.setFloat("depth", isNear ? 0.9f : 0.1f);
      shader.setVec4("tint", isNear ? glm::vec4(1, 0, 0, 1) : glm::vec4(0, 1, 0, 1));
      mesh.draw();
    }
    target.unBind();
    EXPECT_EQ(test::readFloats(target)[8 * 4 + 4], glm::vec4(1, 0, 0, 1));
  }
}

TEST_F(MeshGLTest, passTimerNamesItsClockAndTimesOnlyWhenMeasuring) {
  // On a graphics card by queries, which cost nothing, whoever measures; on a software renderer no clock in
  // play and the wall clock in measuring runs.
  const auto timesOf = [&](gl::PassTimer& timer) {
    gl::FrameBuffer target(context(), 512, 512, {}, "target");
    timer.beginFrame();
    timer.begin("sky");
    target.bind();
    target.unBind();
    timer.end();
    timer.finish();
    return timer.takeMilliseconds();
  };
  if (!context().isSoftware()) {
    gl::PassTimer timer(context(), false);
    EXPECT_EQ(timer.clockName(), "timer query");
    const auto times = timesOf(timer);
    ASSERT_EQ(times.size(), 1u);
    EXPECT_EQ(times[0].first, "sky");
    return;
  }
  gl::PassTimer playing(context(), false);
  playing.begin("sky");
  playing.end();
  EXPECT_EQ(playing.clock(), gl::PassClock::none);
  EXPECT_TRUE(playing.takeMilliseconds().empty());

  gl::PassTimer measuring(context(), true);
  EXPECT_EQ(measuring.clockName(), "wall clock between glFinish calls");
  measuring.setMeasuring(false);  // somebody has looked at the times and does so no longer
  EXPECT_EQ(measuring.clockName(), "none");
  measuring.setMeasuring(true);
  const auto times = timesOf(measuring);
  ASSERT_EQ(times.size(), 1u);
  EXPECT_EQ(times[0].first, "sky");
  EXPECT_GT(times[0].second, 0.0);
  EXPECT_TRUE(measuring.takeMilliseconds().empty());
}

}  // namespace
}  // namespace skydrop::render
