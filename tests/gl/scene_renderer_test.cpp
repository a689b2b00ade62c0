#include "app/session/scene_renderer.h"

#include <gtest/gtest.h>

#include <chrono>

#include "app/session/run_config.h"
#include "skydrop/render/clouds/cloud_dome.h"
#include "skydrop/render/clouds/cloud_plane.h"
#include "support/gl_test.h"
#include "support/shared_noise.h"

namespace skydrop::app {
namespace {

// The scene that the game starts with, and one without clouds.
class SceneRendererGLTest : public test::GLTest {
 protected:
  static std::unique_ptr<app::RunConfig> preparedOf(const char* scene) {
    CommandLine line;
    line.verb = Verb::render;
    line.scene = scene;
    return prepareRun(line);
  }

  static SceneRenderer::Setup setupOf(const Simulation& simulation) {
    const bool hasClouds = simulation.effects().contains(scene::Effect::clouds);
    return {simulation.effects(), simulation.ground(), 1, false,
            hasClouds ? PreparedResources(test::sharedNoise()) : PreparedResources()};
  }
};

class AnySceneRendererGLTest : public SceneRendererGLTest, public testing::WithParamInterface<const char*> {
 protected:
  static std::unique_ptr<app::RunConfig> prepared() { return preparedOf(GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(, AnySceneRendererGLTest, testing::Values(kDefaultScene, "terrain"),
                         [](const auto& scene) { return std::string(scene.param); });

TEST_P(AnySceneRendererGLTest, afterWarmingUpNoFrameCompilesAShader) {
  // Warmed up: the first frames with the aircraft ahead, with a package in the air and with a target in sight
  // use programs that are there already.
  const auto run = prepared();
  Simulation simulation(run->setup, run->settings, run->table);
  SceneRenderer sceneRenderer(context(), setupOf(simulation), run->settings);
  const Size size{160, 90};
  game::Snapshot shown = simulation.world().now();
  sceneRenderer.warmUp(shown, size);
  const std::int64_t warm = context().resources().live(render::gl::ObjectKind::program);
  const auto workOf = [&](const char* pass) {
    core::FrameStatistics statistics;
    sceneRenderer.writeTo(statistics);
    for (const auto& [name, row] : statistics.passes) {
      if (name == pass) return row.draws + row.dispatches;
    }
    return std::int64_t{0};
  };

  sceneRenderer.camera().setMode(render::CameraMode::chase);
  game::PackageSnapshot package;
  package.position = shown.aircraft.position + shown.aircraft.orientation * glm::dvec3(0, 0, -20);
  package.parachuteOpen = 0.5;
  shown.packages = {package};
  shown.target.present = true;
  shown.target.position = shown.aircraft.position + shown.aircraft.orientation * glm::dvec3(0, -50, -400);
  shown.target.radius = 50;
  sceneRenderer.draw(shown, size, Streaming::asItComes);
  EXPECT_GT(workOf("aircraft"), 0);
  EXPECT_GT(workOf("packages"), 0);
  EXPECT_GT(workOf("marker"), 0);
  if (simulation.effects().contains(scene::Effect::clouds)) {
    EXPECT_GT(workOf("clouds"), 0);
  }
  EXPECT_EQ(context().resources().live(render::gl::ObjectKind::program), warm);
}

TEST_P(AnySceneRendererGLTest, theGpusMemoryIsWithinItsBudget) {
  // All textures and buffers at 640 x 360, those of the land's chunks above all: at most 128 MiB, and 24 MiB
  // more where trees, ground, water and villages are drawn from close by.
  const auto run = prepared();
  Simulation simulation(run->setup, run->settings, run->table);
  SceneRenderer sceneRenderer(context(), setupOf(simulation), run->settings);
  sceneRenderer.draw(simulation.world().now(), {640, 360}, Streaming::asItComes);
  core::FrameStatistics statistics;
  sceneRenderer.writeTo(statistics);
  EXPECT_GT(statistics.gl.bytes, 32 << 20);
  const bool isLow = simulation.effects().contains(scene::Effect::vegetation);
  EXPECT_LE(statistics.gl.bytes, isLow ? 152 << 20 : 128 << 20);
}

TEST_P(AnySceneRendererGLTest, cloudSheetsCostNothingWhereNoSceneCallsForThem) {
  // Without the effects: no pass, no row in the statistics. With them, on the same scene: two passes, and
  // programs, textures and draws that the frame did not have.
  const auto run = prepared();
  Simulation simulation(run->setup, run->settings, run->table);
  const auto frame = [&](const SceneRenderer::Setup& setup, bool has) {
    SceneRenderer sceneRenderer(context(), setup, run->settings);
    auto* planes = sceneRenderer.renderer().find<render::CloudPlanes>();
    auto* dome = sceneRenderer.renderer().find<render::CloudDome>();
    EXPECT_EQ(planes != nullptr, has);
    EXPECT_EQ(dome != nullptr, has);
    sceneRenderer.draw(simulation.world().now(), {64, 36}, Streaming::settled);
    core::FrameStatistics statistics;
    sceneRenderer.writeTo(statistics);
    for (const auto& [name, row] : statistics.passes) {
      if (name == "cloudPlanes" || name == "cloudDome") {
        EXPECT_TRUE(has) << name;
      }
    }
    return statistics.gl;
  };
  SceneRenderer::Setup setup = setupOf(simulation);
  const auto without = frame(setup, false);
  setup.effects.insert(scene::Effect::cloudPlanes);
  setup.effects.insert(scene::Effect::cloudDome);
  const auto with = frame(setup, true);
  // A program each, as a picture alone needs no other variant, and the plane the heights of mountains' shade.
  ASSERT_TRUE(setup.effects.contains(scene::Effect::landShadows));
  EXPECT_EQ(with.programs, without.programs + 2);
  EXPECT_EQ(with.textures, without.textures + 5);
}

TEST_F(SceneRendererGLTest, whatComesIsCompiledElsewhereFirst) {
  // The first rounds of a switch add nothing to the flight's context; afterwards the picture is that of a
  // switch without it. A second switch does not wait for what the first one had begun.
  const auto run = preparedOf("empty");
  Simulation simulation(run->setup, run->settings, run->table);
  const scene::EffectSet before = simulation.effects();
  scene::EffectSet after = before;
  after.insert(scene::Effect::sky);
  const Size size{80, 45};
  const auto pictureAfter = [&](bool compilesAhead, int& roundsBefore) {
    SceneRenderer::Setup setup = setupOf(simulation);
    setup.compilesAhead = compilesAhead;
    SceneRenderer renderer(context(), setup, run->settings);
    const game::Snapshot& shown = simulation.world().now();
    renderer.warmUp(shown, size);
    const std::int64_t programs = context().resources().live(render::gl::ObjectKind::program);
    renderer.beginSwitch(after, simulation.ground());
    const auto until = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    for (int round = 0; renderer.isSwitching(); ++round) {
      if (std::chrono::steady_clock::now() > until) {
        ADD_FAILURE() << "the switch has no end";
        break;
      }
      renderer.continueSwitch({}, shown, 10);
      if (context().resources().live(render::gl::ObjectKind::program) == programs) roundsBefore = round;
      if (compilesAhead && round == 0) {  // given up at once, and asked for again
        const auto begin = std::chrono::steady_clock::now();
        renderer.beginSwitch(before, simulation.ground());
        renderer.beginSwitch(after, simulation.ground());
        EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(200));
      }
      renderer.draw(shown, size, Streaming::asItComes);
    }
    renderer.draw(shown, size, Streaming::settled);
    return renderer.renderer().readBack();
  };
  int roundsAhead = 0, rounds = 0;
  const core::Image ahead = pictureAfter(true, roundsAhead), alone = pictureAfter(false, rounds);
  EXPECT_EQ(ahead.rgba, alone.rgba);
  EXPECT_GT(roundsAhead, rounds);
}

}  // namespace
}  // namespace skydrop::app
