// Fixture of tests that look at the light of sky and level plains, before the tone map, with passes of their
// own.
#pragma once

#include <glm/vec4.hpp>
#include <memory>
#include <utility>
#include <vector>

#include "skydrop/render/sky/sky_pass.h"
#include "support/frame_test.h"
#include "support/light_probe.h"
#include "support/plains_pass.h"
#include "support/temporary_folder.h"

namespace skydrop::test {

class PlainsTest : public FrameTest {
 protected:
  void SetUp() override {
    FrameTest::SetUp();
    if (IsSkipped()) return;
    renderer().add(std::make_unique<LightProbe>(light_));
    renderer().add(std::make_unique<render::SkyPass>(context()));
    renderer().add(std::make_unique<PlainsPass>(context(), folder_, plains_));
    settings_.sun.elevationDegrees = 40;
  }

  template <class Pass, class... Arguments>
  Pass* add(Arguments&&... arguments) {
    auto pass = std::make_unique<Pass>(context(), std::forward<Arguments>(arguments)...);
    Pass* added = pass.get();
    renderer().add(std::move(pass));
    return added;
  }

  TemporaryFolder folder_;
  std::vector<Plain> plains_;     // that the next frame draws; none at first
  std::vector<glm::vec4> light_;  // of the last frame
};

}  // namespace skydrop::test
