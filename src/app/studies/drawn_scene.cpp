#include "app/studies/drawn_scene.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "app/measure/stopwatch.h"
#include "app/session/observed_picture.h"
#include "app/session/open_context.h"
#include "app/session/start_camera.h"
#include "skydrop/core/fixed_step.h"
#include "skydrop/core/shared.h"

namespace skydrop::app {

namespace shared = core::shared::f64;

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

void DrawnScene::draw(int samples) {
  radiance_.clear();
  const int last = where_.flight ? where_.flight->frames : 0;
  renderer_->setFramesFollow(false);
  for (int frame = usesFramesBefore() ? 0 : last; frame <= last; ++frame) {
    drawFrame(frame, Streaming::settled);
    renderer_->setFramesFollow(usesFramesBefore());
  }
  if (samples > 1) drawSamples(samples);
}

void DrawnScene::drawSamples(int samples) {
  constexpr double kGoldenShare = 0.6180339887498949;
  const game::Snapshot snapshot = snapshotOf(frame_);
  const render::View middle = renderer_->view(snapshot, size_);
  std::vector<glm::dvec3> sum;
  for (int i = 0; i < samples; ++i) {
    render::View view = middle;
    const glm::dvec2 inPixel((i + 0.5) / samples, std::fmod(0.5 + i * kGoldenShare, 1.0));
    view.offAxis += (inPixel - 0.5) * middle.pixelAngleRad();
    renderer_->lookFrom(view);
    renderer_->draw(snapshot, size_, Streaming::settled);
    const std::vector<float> light = renderer_->renderer().readRadiance();
    sum.resize(light.size() / 3);
    for (std::size_t p = 0; p < sum.size(); ++p)
      sum[p] +=
          shared::toneCurve(glm::max(glm::dvec3(light[3 * p], light[3 * p + 1], light[3 * p + 2]), 0.0));
  }
  renderer_->lookFrom(std::nullopt);
  for (const glm::dvec3& curve : sum) {
    const glm::vec3 light(shared::lightOfToneCurve(curve / static_cast<double>(samples)));
    radiance_.insert(radiance_.end(), {light.x, light.y, light.z});
  }
}

std::vector<float> DrawnScene::radiance() {
  return radiance_.empty() ? renderer_->renderer().readRadiance() : radiance_;
}

core::Image DrawnScene::picture() {
  return radiance_.empty() ? renderer_->renderer().readBack()
                           : seenPicture(radiance_, size_.width, size_.height);
}

game::Snapshot DrawnScene::snapshotOf(int frame) const {
  game::Snapshot snapshot = simulation_->world().now();
  snapshot.simulatedSeconds += frame / accuracy::kFlightFramesPerSecond;
  return snapshot;
}

void DrawnScene::drawFrame(int frame, Streaming streaming) {
  if (where_.pose) {
    std::array<double, 6> p = *where_.pose;
    if (where_.flight) p = accuracy::flownPose(p, *where_.flight, frame);
    placeCamera(renderer_->camera(), Pose{{p[0], p[1], p[2]}, p[3], p[4], p[5]}, *simulation_->ground());
  }
  frame_ = frame;
  renderer_->draw(snapshotOf(frame), size_, streaming);
}

double DrawnScene::timeFrame() {
  renderer_->renderer().finish();
  const Stopwatch watch;
  drawFrame(where_.flight ? frame_ + 1 : 0, Streaming::asItComes);
  renderer_->renderer().finish();
  return watch.ms();
}

double DrawnScene::timePasses(const std::string& names) {
  renderer_->setMeasuring(true);
  timeFrame();
  core::FrameStatistics statistics;
  renderer_->writeTo(statistics, 1);
  renderer_->setMeasuring(false);
  passClock_ = statistics.clock;
  const std::string listed = '+' + names + '+';
  double ms = 0;
  for (const auto& [pass, of] : statistics.passes) {
    if (of.skipped.empty() && listed.find('+' + pass + '+') != std::string::npos) ms += of.ms;
  }
  return ms;
}

}  // namespace skydrop::app
