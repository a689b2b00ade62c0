#include "support/gl_test.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>

#include "skydrop/core/error.h"

// Read by the leak sanitizer where it is linked: Mesa keeps some hundred bytes until the process ends.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa.so\n"; }

namespace skydrop::test {

using namespace render;

std::unique_ptr<gl::Context> openForTest(gl::Backend backend, std::string& why) {
  const char* driver = std::getenv("SKYDROP_TEST_DRIVER");
  if (!driver || std::string_view(driver) != "any") setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
  // llvmpipe draws in the thread that asks: suites run side by side, and frames of tests are small.
  setenv("LP_NUM_THREADS", "0", 0);
  try {
    return gl::openHeadless(backend);
  } catch (const core::GraphicsUnavailable& error) {
    why = error.what();
    return nullptr;
  }
}

gl::Backend backendFromEnvironment() {
  const char* name = std::getenv("SKYDROP_TEST_BACKEND");
  return name && std::string_view(name) == "osmesa" ? gl::Backend::osmesa : gl::Backend::egl;
}

void GLTest::SetUp() {
  std::string why;
  context_ = openForTest(backendFromEnvironment(), why);
  if (!context_) GTEST_SKIP() << why;
}

void GLTest::TearDown() {
  if (!context_) return;
  context_->makeCurrent();
  EXPECT_EQ(context_->api().GetError(), static_cast<GLenum>(GL_NO_ERROR));
  for (const gl::DebugMessage& message : context_->debugMessages()) {
    if (message.isError) ADD_FAILURE() << "the driver says: " << message.text;
  }
  EXPECT_EQ(context_->resources().unknownUniforms(), 0u) << context_->resources().lastUnknownUniform();
}

GLTest::~GLTest() {
  // The members of derived fixtures are gone by now.
  if (!context_) return;
  EXPECT_EQ(context_->resources().liveObjects(), 0) << "GL objects were left behind";
}

std::vector<glm::vec4> readFloats(const gl::FrameBuffer& target) {
  std::vector<glm::vec4> texels(static_cast<std::size_t>(target.width() * target.height()));
  target.colorTexture().read(GL_RGBA, GL_FLOAT, std::as_writable_bytes(std::span(texels)));
  return texels;
}

core::Image readImage(const gl::FrameBuffer& target) {
  const std::vector<glm::vec4> texels = readFloats(target);
  core::Image image(target.width(), target.height());
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const glm::vec4& texel = texels[static_cast<std::size_t>((image.height - 1 - y) * image.width + x)];
      for (int c = 0; c < 4; ++c) {
        image.pixel(x, y)[c] =
            static_cast<std::uint8_t>(std::lround(std::clamp(texel[c], 0.0f, 1.0f) * 255.0f));
      }
    }
  }
  return image;
}

std::vector<float> readDepth(const gl::FrameBuffer& target) {
  std::vector<float> depths(static_cast<std::size_t>(target.width() * target.height()));
  target.depthTexture().read(GL_DEPTH_COMPONENT, GL_FLOAT, std::as_writable_bytes(std::span(depths)));
  return depths;
}

}  // namespace skydrop::test
