#include "app/studies/picture_subject.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>

#include "app/measure/system_info.h"
#include "app/session/observed_picture.h"
#include "app/studies/subjects.h"
#include "skydrop/core/error.h"

namespace skydrop::app {
namespace {

constexpr std::size_t kMostScenes = 8;  // each holds its land and textures

// What a study turns beside the program's settings.
struct Sampling {
  std::int64_t samples = 1;  // a pixel, each a frame of its own
};

void describe(core::SettingsVisitor& visitor, Sampling& s) {
  visitor.integer("samples", s.samples, {.unit = "1", .min = 1, .max = 1024, .help = "Samples a pixel."});
}

bool isOfSampling(const std::string& assignment) { return assignment.starts_with("samples="); }

// Throws core::RangeError.
Sampling samplingOf(const accuracy::Experiment& experiment) {
  Sampling sampling;
  const core::SettingsTable table(sampling);
  for (const std::string& one : experiment.set) {
    if (isOfSampling(one)) core::setField(table, one);
  }
  return sampling;
}

std::unique_ptr<RunConfig> runOf(const accuracy::Experiment& experiment) {
  CommandLine line;
  line.verb = Verb::accuracy;
  if (!experiment.where.scene.empty()) line.scene = experiment.where.scene;
  std::ranges::remove_copy_if(experiment.set, std::back_inserter(line.set), isOfSampling);
  return prepareRun(line);
}

// What makes another scene: values that nothing can change while flying, or that the simulation depends on.
std::string sceneKey(const accuracy::Experiment& experiment, const RunConfig& run) {
  std::string key = experiment.where.scene + " " + std::to_string(experiment.where.seconds);
  for (const core::Field& field : run.table.fields()) {
    if (field.takesEffect == core::TakesEffect::restart || field.path.starts_with("effects.") ||
        decidesSimulation(field.path))
      key += " " + core::fieldText(field);
  }
  return key;
}

std::string keyOf(const accuracy::Experiment& experiment) {
  std::string key = experiment.where.scene + "\n" + experiment.timed;
  for (const std::string& one : experiment.set) key += "\n" + one;
  return key;
}

bool isPass(const accuracy::Experiment& experiment) { return experiment.timed.starts_with("pass "); }

}  // namespace

std::unique_ptr<accuracy::Subject> makePictureSubject(Size size) {
  return std::make_unique<PictureSubject>(size);
}

accuracy::Assignments PictureSubject::checked(const accuracy::Experiment& experiment) const {
  const std::string key = keyOf(experiment);
  if (const auto known = checked_.find(key); known != checked_.end()) return known->second;
  if (experiment.timed == "cpu") throw core::RangeError("timed: a picture is timed by frame or pass NAME");
  const std::unique_ptr<RunConfig> run = runOf(experiment);
  accuracy::Assignments all;
  if (const Sampling sampling = samplingOf(experiment); sampling.samples > 1)
    all.push_back("samples=" + std::to_string(sampling.samples));
  for (const std::string& one : experiment.set) {
    if (isOfSampling(one)) continue;
    const core::Field& field = run->table.at(one.substr(0, one.find('=')));
    all.push_back(field.path + "=" + core::fieldText(field));
  }
  return checked_[key] = all;
}

DrawnScene& PictureSubject::shown(const accuracy::Experiment& experiment) {
  std::unique_ptr<RunConfig> run = runOf(experiment);
  const Settings settings = run->settings;
  const std::string key = sceneKey(experiment, *run);
  auto found = scenes_.find(key);
  if (found == scenes_.end()) {
    if (scenes_.size() >= kMostScenes) scenes_.clear();
    auto scene = std::make_unique<DrawnScene>(std::move(run), experiment.where.seconds, size_, table_);
    device_ = scene->device();
    found = scenes_.emplace(key, std::move(scene)).first;
  }
  found->second->set(settings, experiment.where);
  return *found->second;
}

accuracy::Observation PictureSubject::observe(const accuracy::Experiment& experiment) {
  DrawnScene& scene = shown(experiment);
  scene.draw(static_cast<int>(samplingOf(experiment).samples));
  core::Image display = scene.picture();
  accuracy::Observation observation = observedPicture(scene.radiance(), display.width, display.height);
  observation.display = std::move(display);
  return observation;
}

double PictureSubject::timeOnce(const accuracy::Experiment& experiment) {
  DrawnScene& scene = shown(experiment);
  scene.draw();
  const auto samples = static_cast<double>(samplingOf(experiment).samples);
  if (!isPass(experiment)) return samples * scene.timeFrame();
  const double ms = scene.timePasses(experiment.timed.substr(5));
  passClock_ = scene.passClock();
  return samples * ms;
}

std::string PictureSubject::clock(const accuracy::Experiment& experiment) const {
  return isPass(experiment) ? passClock_ : "wall clock between glFinish calls";
}

std::string PictureSubject::machine() const {
  return machineName() + ", " + device_ + ", " + std::to_string(size_.width) + " x " +
         std::to_string(size_.height);
}

}  // namespace skydrop::app
