#include "app/stage.h"

#include <gtest/gtest.h>

#include "app/prepare.h"
#include "support/gl_test.h"

namespace skydrop::app {
namespace {

using StageGLTest = test::GLTest;

std::unique_ptr<Run> runOf(const std::string& scene) {
  CommandLine line;
  line.verb = Verb::render;
  line.scene = scene;
  return prepareRun(line);
}

TEST_F(StageGLTest, afterWarmingUpNoFrameCompilesAShader) {
  // The scene without clouds, warmed up: the first frames with the aircraft ahead, with a package in the air and
  // with a target in sight use programs that are there already.
  const auto run = runOf("terrain");
  Simulation simulation(run->setup, run->settings, run->table);
  Stage stage(context(), {simulation.effects(), simulation.ground(), 1, false}, run->settings);
  const Size size{160, 90};
  game::Snapshot shown = simulation.world().now();
  stage.warmUp(shown, size);
  const std::int64_t warm = context().ledger().live(render::gl::ObjectKind::program);
  const auto drawsOf = [&](const char* pass) {
    core::FrameStatistics statistics;
    stage.writeTo(statistics);
    for (const auto& [name, row] : statistics.passes) {
      if (name == pass) return row.draws;
    }
    return std::int64_t{0};
  };

  stage.camera().setMode(render::CameraMode::chase);
  game::PackageSnapshot package;
  package.position = shown.aircraft.position + shown.aircraft.orientation * glm::dvec3(0, 0, -20);
  package.parachuteOpen = 0.5;
  shown.packages = {package};
  shown.target.present = true;
  shown.target.position = shown.aircraft.position + shown.aircraft.orientation * glm::dvec3(0, -50, -400);
  shown.target.radius = 50;
  stage.draw(shown, size, Streaming::asItComes);
  EXPECT_GT(drawsOf("aircraft"), 0);
  EXPECT_GT(drawsOf("packages"), 0);
  EXPECT_GT(drawsOf("marker"), 0);
  EXPECT_EQ(context().ledger().live(render::gl::ObjectKind::program), warm);
}

TEST_F(StageGLTest, theGpusMemoryIsWithinItsBudget) {
  // All textures and buffers of the scene without clouds at 640 x 360, those of the land's chunks above all: at most
  // 128 MiB.
  const auto run = runOf("terrain");
  Simulation simulation(run->setup, run->settings, run->table);
  Stage stage(context(), {simulation.effects(), simulation.ground(), 1, false}, run->settings);
  stage.draw(simulation.world().now(), {640, 360}, Streaming::asItComes);
  core::FrameStatistics statistics;
  stage.writeTo(statistics);
  EXPECT_GT(statistics.gl.bytes, 32 << 20);
  EXPECT_LE(statistics.gl.bytes, 128 << 20);
}

}  // namespace
}  // namespace skydrop::app
