// Where a guard of the shading fired, shown in the picture (render.picture.guardMarks).
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "skydrop/render/frame/tone_map_pass.h"
#include "support/frame_test.h"
#include "support/plains_pass.h"

namespace skydrop::render {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN(),
                kInfinity = std::numeric_limits<float>::infinity();

class GuardMarksGLTest : public test::FrameTest {
 protected:
  void SetUp() override {
    FrameTest::SetUp();
    if (IsSkipped()) return;
    renderer().add(std::make_unique<test::PlainsPass>(context(), folder_, plains_));
    renderer().add(std::make_unique<ToneMapPass>(context()));
  }

  // A picture that is filled with this light.
  core::Image filled(const glm::vec3& light) {
    plains_ = {{0, light}};
    return draw(pose({0, 100, 0}, 0, -90, 0));
  }

  bool hasVariant() {
    for (const gl::ShaderProgram* program : renderer().shaders().programs()) {
      const auto& defines = program->defines();
      if (std::find(defines.begin(), defines.end(), "GUARD_MARKS") != defines.end()) return true;
    }
    return false;
  }

  test::TemporaryFolder folder_;
  std::vector<test::Plain> plains_;
};

int apart(const core::Image& image, const glm::ivec3& color) {
  int most = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(image.pixel(x, y)[c] - color[c]));
    }
  }
  return most;
}

TEST_F(GuardMarksGLTest, lightThatIsCutNegativeOrNoNumberHasAColourOfItsOwn) {
  // Every pixel, within the dither's level; the worst of the channels counts.
  settings_.guardMarks = true;
  for (const glm::vec3& bad : {glm::vec3(kNaN), glm::vec3(0.2f, kNaN, 60000), glm::vec3(kInfinity, 0, 0),
                               glm::vec3(0, 0, -kInfinity)})
    EXPECT_LE(apart(filled(bad), {255, 0, 255}), 1) << bad.x << ' ' << bad.y;
  EXPECT_LE(apart(filled({0.2f, -0.1f, 60000}), {0, 255, 255}), 1);
  EXPECT_LE(apart(filled({0.2f, 60000, 0.2f}), {255, 255, 0}), 1);
}

TEST_F(GuardMarksGLTest, whatNoGuardHeldBackIsHalfAsBright) {
  // The marks stand out of a picture that is darker, and nothing else of it is changed.
  const core::Image plain = filled({0.2f, 0.4f, 0.1f});
  settings_.guardMarks = true;
  const core::Image marked = filled({0.2f, 0.4f, 0.1f});
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(marked.pixel(5, 5)[c], plain.pixel(5, 5)[c] / 2.0, 1.5) << c;
}

TEST_F(GuardMarksGLTest, aFrameWithoutThemHasNothingOfThem) {
  // No program with them is compiled until somebody asks; when they go, the picture is that of before, to the
  // bit.
  const core::Image before = filled({0.2f, kNaN, 60000});
  EXPECT_FALSE(hasVariant());
  settings_.guardMarks = true;
  EXPECT_NE(filled({0.2f, kNaN, 60000}).rgba, before.rgba);
  EXPECT_TRUE(hasVariant());
  settings_.guardMarks = false;
  EXPECT_EQ(filled({0.2f, kNaN, 60000}).rgba, before.rgba);
}

}  // namespace
}  // namespace skydrop::render
