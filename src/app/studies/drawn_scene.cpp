#include "app/studies/drawn_scene.h"

#include <cmath>

#include "app/measure/stopwatch.h"
#include "app/session/open_context.h"
#include "app/session/start_camera.h"
#include "skydrop/core/fixed_step.h"

namespace skydrop::app {

DrawnScene::DrawnScene(std::unique_ptr<RunConfig> run, double seconds, Size size,
                       const std::vector<EffectDescriptor>& table)
    : run_(std::move(run)), size_(size), context_(openContext(std::nullopt, size)), preparations_(table) {
  const scene::EffectSet effects = effectsOf(*run_);
  preparations_.begin(effects, Preparation::Maker::processor, run_->settings);
  simulation_ = std::make_unique<Simulation>(run_->setup, run_->settings, run_->table);
  const auto steps = std::llround(seconds * core::FixedStep::kStepsPerSecond);
  for (long long i = 0; i < steps; ++i) simulation_->step({});
  preparations_.waitUntilReady();
  renderer_ = std::make_unique<SceneRenderer>(*context_,
                                              SceneRenderer::Setup{.effects = effects,
                                                                   .ground = simulation_->ground(),
                                                                   .workers = std::nullopt,
                                                                   .measuring = false,
                                                                   .prepared = preparations_.results(effects),
                                                                   .table = &table,
                                                                   .images = simulation_->images()},
                                              run_->settings);
}

DrawnScene::~DrawnScene() { context_->makeCurrent(); }

void DrawnScene::set(const Settings& settings, const accuracy::StudyCase& where) {
  context_->makeCurrent();
  Settings before = run_->settings;
  run_->settings = settings;
  renderer_->apply(SettingsChange::between(core::SettingsTable(before), run_->table));
  where_ = where;
  if (!where.pose) renderer_->camera().setMode(settings.view.camera);
}

bool DrawnScene::usesFramesBefore() const {
  return where_.flight && run_->settings.clouds.march.history != clouds::MarchHistory::off;
}

void DrawnScene::draw() {
  const int last = where_.flight ? where_.flight->frames : 0;
  renderer_->setFramesFollow(false);
  for (int frame = usesFramesBefore() ? 0 : last; frame <= last; ++frame) {
    drawFrame(frame, Streaming::settled);
    renderer_->setFramesFollow(usesFramesBefore());
  }
}

void DrawnScene::drawFrame(int frame, Streaming streaming) {
  game::Snapshot snapshot = simulation_->world().now();
  if (where_.pose) {
    std::array<double, 6> p = *where_.pose;
    if (where_.flight) p = accuracy::flownPose(p, *where_.flight, frame);
    placeCamera(renderer_->camera(), Pose{{p[0], p[1], p[2]}, p[3], p[4], p[5]}, *simulation_->ground());
  }
  snapshot.simulatedSeconds += frame / accuracy::kFlightFramesPerSecond;
  frame_ = frame;
  renderer_->draw(snapshot, size_, streaming);
}

double DrawnScene::timeFrame() {
  renderer_->renderer().finish();
  const Stopwatch watch;
  drawFrame(where_.flight ? frame_ + 1 : 0, Streaming::asItComes);
  renderer_->renderer().finish();
  return watch.ms();
}

double DrawnScene::timePass(const std::string& name) {
  renderer_->setMeasuring(true);
  timeFrame();
  core::FrameStatistics statistics;
  renderer_->writeTo(statistics, 1);
  renderer_->setMeasuring(false);
  passClock_ = statistics.clock;
  for (const auto& [pass, of] : statistics.passes) {
    if (pass == name) return of.skipped.empty() ? of.ms : 0;
  }
  return 0;
}

}  // namespace skydrop::app
