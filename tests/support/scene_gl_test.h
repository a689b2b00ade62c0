// The fixture of tests that draw a scene as the program does: a command line, the simulation that it makes,
// and who draws it.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/session/run_config.h"
#include "app/session/scene_renderer.h"
#include "app/session/simulation.h"
#include "support/gl_test.h"

namespace skydrop::test {

class SceneGLTest : public GLTest {
 protected:
  // Of `skydrop render --scene SCENE`: `set` and then `more` as by --set.
  static app::CommandLine lineOf(std::string scene, std::vector<std::string> set,
                                 const std::vector<std::string>& more = {}) {
    app::CommandLine line;
    line.verb = app::Verb::render;
    line.scene = std::move(scene);
    line.set = std::move(set);
    line.set.insert(line.set.end(), more.begin(), more.end());
    return line;
  }
  // framesFollow: as of SceneRenderer::Setup.
  void beginScene(const app::CommandLine& line, int workers = 2, bool framesFollow = false) {
    run_ = app::prepareRun(line);
    simulation_ = std::make_unique<app::Simulation>(run_->setup, run_->settings, run_->table);
    sceneRenderer_ =
        std::make_unique<app::SceneRenderer>(context(),
                                             app::SceneRenderer::Setup{.effects = simulation_->effects(),
                                                                       .ground = simulation_->ground(),
                                                                       .workers = workers,
                                                                       .framesFollow = framesFollow,
                                                                       .images = simulation_->images()},
                                             run_->settings);
  }
  void TearDown() override {
    sceneRenderer_.reset();
    GLTest::TearDown();
  }

  // A setting of a flight under way.
  void set(const std::string& assignment) {
    core::setField(run_->table, assignment);
    sceneRenderer_->apply(app::SettingsChange::ofAll(run_->table));
  }

  std::unique_ptr<app::RunConfig> run_;
  std::unique_ptr<app::Simulation> simulation_;
  std::unique_ptr<app::SceneRenderer> sceneRenderer_;
};

}  // namespace skydrop::test
