#include "app/studies/measured_game.h"

#include "app/input/bindings.h"
#include "app/measure/bill.h"
#include "app/measure/stopwatch.h"
#include "app/session/lightning_effect.h"
#include "app/session/open_context.h"
#include "skydrop/core/fixed_step.h"

namespace skydrop::app {
namespace {

constexpr int kFramesPerSecond = 60;
constexpr int kStepsPerFrame = core::FixedStep::kStepsPerSecond / kFramesPerSecond;

std::unique_ptr<RunConfig> runOf(const MeasuredGame::Setup& setup) {
  CommandLine line;
  line.verb = Verb::accuracy;
  line.scene = setup.scene;
  line.set = setup.set;
  return prepareRun(line);
}

// A machine without a sound device must not find sound cheaper.
std::unique_ptr<audio::AudioManager> openSound(const audio::AudioSettings& settings) {
  using Output = audio::AudioManager::Output;
  try {
    return std::make_unique<audio::AudioManager>(settings, Output::loopback);
  } catch (const std::runtime_error&) {
    return std::make_unique<audio::AudioManager>(settings, Output::device);
  }
}

}  // namespace

MeasuredGame::MeasuredGame(const Setup& setup)
    : size_(setup.size), run_(runOf(setup)), context_(openContext(std::nullopt, setup.size)) {
  const scene::EffectSet effects = effectsOf(*run_);
  preparations_.begin(effects, Preparation::Maker::processor, run_->settings);
  simulation_ = std::make_unique<Simulation>(run_->setup, run_->settings, run_->table);
  preparations_.waitUntilReady();
  sceneRenderer_ =
      std::make_unique<SceneRenderer>(*context_,
                                      SceneRenderer::Setup{.effects = effects,
                                                           .ground = simulation_->ground(),
                                                           .prepared = preparations_.results(effects),
                                                           .images = simulation_->images()},
                                      run_->settings);
  if (effects.contains(scene::Effect::hud)) {
    overlay_ = std::make_unique<Overlay>(effects, size_, helpRows(Bindings()));
    sceneRenderer_->addOverlay();
  }
  if (effects.contains(scene::Effect::sound)) {
    audio_ = openSound(run_->settings.audio);
    sound_ = std::make_unique<audio::SoundScene>(*audio_, run_->settings.audio);
    sound_->setLightning(lightningOf(effects, run_->settings));
  }
  const game::Snapshot& start = simulation_->world().now();
  sceneRenderer_->warmUp(start, size_);
  show({start, sceneRenderer_->view(start, size_)});
}

MeasuredGame::~MeasuredGame() { context_->makeCurrent(); }

void MeasuredGame::show(const Sight& sight) {
  sight_ = sight;
  context_->makeCurrent();
  sceneRenderer_->camera().setMode(render::CameraMode::free);
  sceneRenderer_->camera().standAt(sight.view);
  buildInterface();
  sceneRenderer_->draw(sight_.snapshot, size_, Streaming::settled);
}

void MeasuredGame::setMeasuring(bool measuring) {
  sceneRenderer_->setMeasuring(measuring);
  simulation_->setMeasuring(measuring);
  soundCost_.setMeasuring(measuring);
  if (overlay_) overlay_->setMeasuring(measuring);
}

void MeasuredGame::buildInterface() {
  if (!overlay_) return;
  const OverlayFrame content{sight_.snapshot, size_, 1.0 / kFramesPerSecond, run_->table};
  if (overlay_->build(content).fontsChanged) sceneRenderer_->uploadFonts();
}

double MeasuredGame::frame() {
  context_->makeCurrent();
  sceneRenderer_->renderer().finish();
  const Stopwatch watch;
  for (int i = 0; i < kStepsPerFrame; ++i) simulation_->step({});
  const std::vector<game::GameEvent> events = simulation_->world().takeEvents();
  if (sound_) {
    soundCost_.measure([&] { sound_->update(simulation_->world().now(), events); });
    soundCost_.endRound();
  }
  buildInterface();
  sceneRenderer_->draw(sight_.snapshot, size_, Streaming::asItComes);
  sceneRenderer_->renderer().finish();
  return watch.ms();
}

core::FrameStatistics MeasuredGame::statistics() {
  core::FrameStatistics statistics;
  simulation_->writeTo(statistics);
  sceneRenderer_->writeTo(statistics, 1);
  if (overlay_) overlay_->writeTo(statistics);
  if (sound_) billRow(statistics, scene::nameOf(scene::Effect::sound)).updateMs += soundCost_.meanMs();
  return statistics;
}

}  // namespace skydrop::app
