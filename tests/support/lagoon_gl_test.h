// The fixture of tests that look at water: the scene `lagoon` without clouds, aircraft and interface, at one
// moment.
#pragma once

#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "support/scene_gl_test.h"

namespace skydrop::test {

class LagoonGLTest : public SceneGLTest {
 protected:
  static constexpr app::Size kSize{192, 108};
  static constexpr glm::dvec2 kOpenSea{4400, 4300}, kShore{3930, 6620};

  void begin(const std::vector<std::string>& set = {}) {
    beginScene(lineOf("lagoon",
                      {"effects.clouds=false", "effects.targets=false", "effects.hud=false",
                       "effects.landShadows=false"},
                      set),
               1);
    snapshot_ = simulation_->world().now();
    snapshot_.aircraft.present = false;
    snapshot_.simulatedSeconds = 40;
    sceneRenderer_->camera().setMode(render::CameraMode::free);
  }
  // So high above the sea at a place, m; yaw 0 looks along +x.
  void look(const glm::dvec2& at, double aboveM, double yawDeg, double pitchDeg) {
    sceneRenderer_->camera().setPose({at.x, aboveM, at.y}, glm::radians(yawDeg), glm::radians(pitchDeg), 0);
  }
  core::Image frame() {
    sceneRenderer_->draw(snapshot_, kSize, app::Streaming::settled);
    return sceneRenderer_->renderer().readBack();
  }
  std::vector<float> light() {
    frame();
    return sceneRenderer_->renderer().readRadiance();
  }

  game::Snapshot snapshot_;
};

}  // namespace skydrop::test
