#include "bench/bench_game.h"

#include <chrono>
#include <glm/trigonometric.hpp>

#include "app/input/bindings.h"
#include "app/session/open_context.h"
#include "support/shared_noise.h"

namespace skydrop::bench {
namespace {

std::unique_ptr<app::RunConfig> runOf(const BenchGame::Setup& setup) {
  app::CommandLine line;
  line.verb = app::Verb::render;
  line.scene = setup.scene;
  line.set = setup.set;
  if (setup.without) line.set.push_back("effects." + std::string(scene::nameOf(*setup.without)) + "=false");
  return app::prepareRun(line);
}

app::PreparedResources preparedFor(const scene::EffectSet& effects) {
  return effects.contains(scene::Effect::clouds) ? app::PreparedResources(test::sharedNoise())
                                                 : app::PreparedResources();
}

}  // namespace

BenchGame::BenchGame(const Setup& setup)
    : run_(runOf(setup)),
      context_(app::openContext(std::nullopt, kFrameSize)),
      simulation_(run_->setup, run_->settings, run_->table),
      sceneRenderer_(*context_,
                     {.effects = simulation_.effects(),
                      .ground = simulation_.ground(),
                      .measuring = setup.measuring,
                      .prepared = preparedFor(simulation_.effects()),
                      .compilesAhead = true},
                     run_->settings),
      overlay_(simulation_.effects(), kFrameSize, app::helpRows(app::Bindings())) {
  sceneRenderer_.addOverlay();
  sceneRenderer_.warmUp(simulation_.world().now(), kFrameSize);
  sceneRenderer_.camera().setMode(render::CameraMode::free);
}

void BenchGame::switchTo(const scene::EffectSet& effects) {
  run_->settings.effects = app::switchesOf(effects);
  simulation_.apply({"effects"});
  prepared_ = preparedFor(effects);
  sceneRenderer_.beginSwitch(effects, simulation_.ground());
}

double BenchGame::continueSwitch(double budgetMs) {
  const auto begin = std::chrono::steady_clock::now();
  sceneRenderer_.continueSwitch(prepared_, simulation_.world().now(), budgetMs);
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

void BenchGame::set(const std::string& assignment) {
  app::Settings before = run_->settings;
  core::setField(run_->table, assignment);
  sceneRenderer_.apply(app::SettingsChange::between(core::SettingsTable(before), run_->table));
}

double BenchGame::draw(const app::Pose& pose) {
  context_->makeCurrent();  // several games may take turns
  const auto begin = std::chrono::steady_clock::now();
  sceneRenderer_.camera().setPose(pose.position, glm::radians(pose.yawDegrees),
                                  glm::radians(pose.pitchDegrees), glm::radians(pose.rollDegrees));
  game::Snapshot snapshot = simulation_.world().now();
  snapshot.bursts = bursts_;
  const app::OverlayResult built = overlay_.build({snapshot, kFrameSize, 1.0 / 60, run_->table});
  if (built.fontsChanged) sceneRenderer_.uploadFonts();
  sceneRenderer_.draw(snapshot, kFrameSize, app::Streaming::asItComes);
  sceneRenderer_.renderer().finish();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

void BenchGame::settle(const app::Pose& pose) {
  do {
    draw(pose);
  } while (!land().isSettled());
}

double BenchGame::medianMs(std::string_view pass, std::size_t frames) {
  core::FrameStatistics statistics;
  sceneRenderer_.writeTo(statistics, frames);
  for (const auto& [name, row] : statistics.passes)
    if (name == pass) return row.ms;
  return 0;
}

}  // namespace skydrop::bench
