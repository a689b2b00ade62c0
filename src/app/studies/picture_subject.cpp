#include "app/studies/picture_subject.h"

#include <utility>

#include "app/measure/system_info.h"
#include "app/session/observed_picture.h"
#include "app/studies/subjects.h"
#include "skydrop/core/error.h"

namespace skydrop::app {
namespace {

constexpr std::size_t kMostScenes = 8;  // each holds its land and textures

std::unique_ptr<RunConfig> runOf(const accuracy::Experiment& experiment) {
  CommandLine line;
  line.verb = Verb::accuracy;
  if (!experiment.where.scene.empty()) line.scene = experiment.where.scene;
  line.set = experiment.set;
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
  for (const std::string& one : experiment.set) {
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
  found->second->draw();
  return *found->second;
}

accuracy::Observation PictureSubject::observe(const accuracy::Experiment& experiment) {
  DrawnScene& scene = shown(experiment);
  core::Image display = scene.picture();
  accuracy::Observation observation = observedPicture(scene.radiance(), display.width, display.height);
  observation.display = std::move(display);
  return observation;
}

double PictureSubject::timeOnce(const accuracy::Experiment& experiment) {
  DrawnScene& scene = shown(experiment);
  if (!isPass(experiment)) return scene.timeFrame();
  const double ms = scene.timePass(experiment.timed.substr(5));
  passClock_ = scene.passClock();
  return ms;
}

std::string PictureSubject::clock(const accuracy::Experiment& experiment) const {
  return isPass(experiment) ? passClock_ : "wall clock between glFinish calls";
}

std::string PictureSubject::machine() const {
  return machineName() + ", " + device_ + ", " + std::to_string(size_.width) + " x " +
         std::to_string(size_.height);
}

}  // namespace skydrop::app
