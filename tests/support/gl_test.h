// The fixture of every test that draws. Opens the back-end named by SKYDROP_TEST_BACKEND (egl where it is not
// set) and skips the test with the reason where it is not to be had. A test fails if it leaves a GL object
// behind, makes the driver report an error, or sets a uniform that no shader names.
#pragma once

#include <gtest/gtest.h>

#include <glm/vec4.hpp>
#include <memory>
#include <string>
#include <vector>

#include "skydrop/core/image.h"
#include "skydrop/render/gl/context.h"
#include "skydrop/render/gl/frame_buffer.h"

namespace skydrop::test {

// Opens a headless back-end on the software renderer, so that pictures do not depend on the machine's GPU; on
// whatever there is with SKYDROP_TEST_DRIVER=any (tests/device). Null, and the reason in `why`, where there
// is none.
std::unique_ptr<render::gl::Context> openForTest(render::gl::Backend backend, std::string& why);
render::gl::Backend backendFromEnvironment();

class GLTest : public ::testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;
  ~GLTest() override;

  render::gl::Context& context() { return *context_; }
  const render::gl::Functions& api() { return context_->api(); }

  // Tests that provoke messages on purpose take them here before the fixture looks.
  void forgiveDebugErrors() { context_->clearDebugMessages(); }

 private:
  std::unique_ptr<render::gl::Context> context_;
};

// The colour of a target: floats, bottom row first, or 8 bits (values above 1 clipped), top row first.
std::vector<glm::vec4> readFloats(const render::gl::FrameBuffer& target);
core::Image readImage(const render::gl::FrameBuffer& target);
// Depth, bottom row first.
std::vector<float> readDepth(const render::gl::FrameBuffer& target);

}  // namespace skydrop::test
