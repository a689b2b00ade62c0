// Fixture of tests that draw whole frames with the renderer.
#pragma once

#include <glm/trigonometric.hpp>
#include <memory>

#include "skydrop/render/frame/camera.h"
#include "skydrop/render/frame/renderer.h"
#include "skydrop/render/models/model_layer.h"
#include "support/gl_test.h"

namespace skydrop::test {

class FrameTest : public GLTest {
 protected:
  void SetUp() override {
    GLTest::SetUp();
    if (IsSkipped()) return;
    renderer_ = std::make_unique<render::Renderer>(context(), settings_, false);
    renderer_->setLayer(std::make_unique<render::ModelLayer>());
  }
  void TearDown() override {
    GLTest::TearDown();
    renderer_.reset();
  }

  render::Renderer& renderer() { return *renderer_; }
  // Metres and degrees, as in `skydrop render --pose`.
  render::View pose(const glm::dvec3& position, double yaw, double pitch, double roll, int width = 320,
                    int height = 180) const {
    render::Camera camera;
    camera.setMode(render::CameraMode::free);
    camera.setPose(position, glm::radians(yaw), glm::radians(pitch), glm::radians(roll));
    return camera.view(snapshot_, settings_.camera, width, height);
  }
  // Of the game as snapshot_ has it.
  core::Image draw(const render::View& view) { return draw(render::gameFrame(snapshot_, view, features_)); }
  // As a frame of a flight, which follows others and compiles what later ones may need.
  void drawFollowing(const render::View& view) {
    render::FrameInput input = render::gameFrame(snapshot_, view, features_);
    input.followsLast = true;
    draw(input);
  }
  core::Image draw(const render::FrameInput& input) {
    renderer_->apply(settings_);
    renderer_->draw(input);
    return renderer_->readBack();
  }

  render::RenderSettings settings_;
  game::Snapshot snapshot_;
  render::FrameFeatures features_{true};

 private:
  std::unique_ptr<render::Renderer> renderer_;
};

}  // namespace skydrop::test
