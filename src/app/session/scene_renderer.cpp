#include "app/session/scene_renderer.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <utility>

#include "app/measure/bill.h"
#include "app/measure/stopwatch.h"
#include "app/session/compile_ahead.h"
#include "app/session/photo_seen.h"
#include "skydrop/render/edges/edge_smoothing_pass.h"
#include "skydrop/render/frame/tone_map_pass.h"
#include "skydrop/render/models/model_layer.h"
#include "skydrop/render/shadows/land_shadow_pass.h"
#include "skydrop/render/shadows/shadow_pass.h"

namespace skydrop::app {
namespace {

constexpr std::string_view kShadowGroup = "shadows", kEdgesGroup = "edges";
// Of frames that nobody sees: small, because programs do not depend on a size. But a software renderer
// compiles one program for textures whose sides are powers of two and another for those whose are not.
Size unseenSize(Size size) {
  const auto isPowerOfTwo = [](int side) { return std::has_single_bit(static_cast<unsigned>(side)); };
  return {isPowerOfTwo(size.width) ? 64 : 80, isPowerOfTwo(size.height) ? 32 : 45};
}

}  // namespace

std::string SceneRenderer::Part::name() const {
  std::string name(scene::nameOf(row->effect));
  if (joint) name += '+' + std::string(scene::nameOf(joint->with));
  return name;
}

SceneRenderer::SceneRenderer(render::gl::Context& context, const Setup& setup, const Settings& settings)
    : setup_(setup), settings_(&settings), renderer_(context, settings.render, setup.measuring) {
  streamingCost_.setMeasuring(setup.measuring);
  camera_.setMode(settings.view.camera);
  renderer_.setLayer(std::make_unique<render::ModelLayer>());
  for (const Part& part : partsOf(setup_.effects)) addPart(part);
  resetEdges();
  renderer_.add(std::make_unique<render::ToneMapPass>(context));
}

SceneRenderer::~SceneRenderer() = default;

// Effects first: what an effect has together with another needs both.
std::vector<SceneRenderer::Part> SceneRenderer::partsOf(const scene::EffectSet& effects) const {
  std::vector<Part> parts;
  for (const EffectDescriptor& row : *setup_.table) {
    if (row.addPasses && effects.contains(row.effect)) parts.push_back({&row});
  }
  for (const EffectDescriptor& row : *setup_.table) {
    if (!effects.contains(row.effect)) continue;
    for (const EffectDescriptor::Joint& joint : row.joints) {
      if (effects.contains(joint.with)) parts.push_back({&row, &joint});
    }
  }
  return parts;
}

void SceneRenderer::addPart(const Part& part) {
  const Stopwatch watch;
  const std::string name = part.name();
  render::gl::GpuResourceTracker& resources = renderer_.context().resources();
  const auto end = [&] {
    renderer_.setGroup({});
    resources.setOwner("");
  };
  renderer_.setGroup({name, static_cast<int>(part.row - setup_.table->data())});
  resources.setOwner(name);
  parts_.push_back(part);  // what a failure has added goes with it
  try {
    (part.joint ? part.joint->addPasses : part.row->addPasses)(*this);
  } catch (...) {
    end();
    removePart(part);
    throw;
  }
  end();
  startMs_[name] = watch.ms();
}

void SceneRenderer::removePart(const Part& part) {
  const std::string name = part.name();
  if (const auto remove = part.joint ? part.joint->remove : part.row->remove) remove(*this);
  if (auto* shadows = renderer_.find<render::ShadowPass>()) {
    shadows->remove(name);
    if (!shadows->hasSources()) renderer_.removeGroup(kShadowGroup);
  }
  renderer_.removeGroup(name);
  startMs_.erase(name);
  std::erase(parts_, part);
}

void SceneRenderer::resetEdges() {
  renderer_.removeGroup(kEdgesGroup);
  if (!settings_->render.smoothEdges) return;
  const render::Renderer::Group owner = renderer_.group();
  renderer_.setGroup({std::string(kEdgesGroup), 0});
  renderer_.add(std::make_unique<render::EdgeSmoothingPass>());
  renderer_.setGroup(owner);
}

void SceneRenderer::castShadow(render::ShadowSource source) {
  const render::Renderer::Group owner = renderer_.group();
  if (!renderer_.find<render::ShadowPass>()) {
    renderer_.setGroup({std::string(kShadowGroup), 0});
    renderer_.add(std::make_unique<render::ShadowPass>());
    renderer_.setGroup(owner);
  }
  renderer_.find<render::ShadowPass>()->add(owner.name, std::move(source));
  parts_.back().castsShadow = true;
}

render::FrameFeatures SceneRenderer::features() const {
  if (switch_ && !switch_->isReady) return switch_->drawnFeatures;
  return frameFeatures(setup_.effects, *setup_.table);
}

void SceneRenderer::beginSwitch(const scene::EffectSet& effects,
                                std::shared_ptr<const terrain::HeightSource> ground) {
  const render::FrameFeatures drawn = features();
  const scene::EffectSet before = std::exchange(setup_.effects, effects);
  setup_.ground = std::move(ground);
  const std::vector<Part> wanted = partsOf(effects);
  const std::vector<Part> present = parts_;
  for (auto part = present.rbegin(); part != present.rend(); ++part) {  // first what needs another
    if (std::ranges::find(wanted, *part) == wanted.end()) removePart(*part);
  }
  if (parts_ != present) {
    renderer_.setLayer(std::make_unique<render::ModelLayer>());
    resetEdges();
  }
  if (before == effects && !switch_) return;
  renderer_.endWarmUp();
  if (switch_ && switch_->ahead) {
    switch_->ahead->giveUp();
    givenUp_.push_back(switch_->ahead);
  }
  switch_ = Switch{.drawnFeatures = drawn};
}

void SceneRenderer::continueSwitch(const PreparedResources& prepared, const game::Snapshot& snapshot,
                                   double budgetMs) {
  if (!switch_) return;
  setup_.prepared = prepared;
  if (!isCompiledAhead(snapshot)) return;
  for (const Part& part : partsOf(setup_.effects)) {
    if (std::ranges::find(parts_, part) != parts_.end()) continue;
    renderer_.holdAdded();
    return addPart(part);
  }
  if (!warmUpInPart(snapshot, budgetMs)) return;
  if (!switch_->isReady) {
    if (land_ && !land_->terrain().isSettled()) return;
    renderer_.releaseHeld();
    renderer_.shaders().beginUse();
    switch_->isReady = true;
    switch_->frame = 0;
    return;
  }
  renderer_.shaders().deleteUnused();
  renderer_.endWarmUp();
  setup_.prepared = {};
  switch_.reset();
}

bool SceneRenderer::isCompiledAhead(const game::Snapshot& snapshot) {
  if (!setup_.compilesAhead) return true;
  std::erase_if(givenUp_, [](const auto& ahead) { return ahead->isDone(); });
  if (!switch_->ahead) {
    if (!givenUp_.empty()) return false;
    switch_->ahead = std::make_shared<CompileAhead>(renderer_.context(), setup_, *settings_, snapshot,
                                                    unseenSize(drawnSize_));
  }
  return switch_->ahead->isDone();
}

// A part of the frames to warm up with; true when all have been drawn.
bool SceneRenderer::warmUpInPart(const game::Snapshot& snapshot, double budgetMs) {
  const std::vector<WarmUpFrame> frames = warmUpFrames(snapshot, unseenSize(drawnSize_));
  const render::FrameFeatures features = frameFeatures(setup_.effects, *setup_.table);
  const Stopwatch watch;
  do {
    if (switch_->frame >= frames.size()) return true;
    const WarmUpFrame& next = frames[switch_->frame];
    if (!drawUnseen(next, features, budgetMs - watch.ms())) return false;
    ++switch_->frame;
    switch_->passesDrawn = 0;
  } while (watch.ms() < budgetMs);
  return switch_->frame >= frames.size();
}

bool SceneRenderer::drawUnseen(const WarmUpFrame& frame, const render::FrameFeatures& features,
                               double budgetMs) {
  render::RenderSettings settings = settings_->render;
  settings.smoothModels = settings.smoothModels && frame.smoothModels;
  renderer_.apply(settings);
  const auto restore = [&] { renderer_.apply(settings_->render); };
  try {
    render::FrameInput input = inputOf(frame.snapshot, frame.view);
    input.features = features;
    input.warmsUp = true;
    const bool complete = renderer_.warmUp(input, budgetMs, switch_->passesDrawn);
    restore();
    return complete;
  } catch (...) {
    restore();
    throw;
  }
}

void SceneRenderer::apply(const SettingsChange& change) {
  if (change.touches("view.camera") && camera_.mode() != settings_->view.camera) {
    camera_.setMode(settings_->view.camera);
    if (camera_.mode() == render::CameraMode::free) freeCamera();
  }
  if (change.touches("render")) renderer_.apply(settings_->render);
  if (change.touches("render.picture.smoothEdges")) resetEdges();
  for (const Part& part : std::vector(parts_)) {
    if (!part.joint && part.row->apply) part.row->apply(*this, change);
  }
}

void SceneRenderer::useSettings(const Settings& settings) {
  Settings before = *settings_, now = settings;
  settings_ = &settings;
  apply(SettingsChange::between(core::SettingsTable(before), core::SettingsTable(now)));
}

void SceneRenderer::freeCamera() {
  if (lastView_) camera_.standAt(*lastView_);
  camera_.setMode(render::CameraMode::free);
}

// The interface is the HUD's, and the menu's where there is no HUD: then nobody owns it but the frame.
void SceneRenderer::addOverlay() {
  render::gl::GpuResourceTracker& resources = renderer_.context().resources();
  const std::string owner(scene::nameOf(scene::Effect::hud));
  renderer_.setGroup({owner, 0});
  resources.setOwner(owner);
  auto pass = std::make_unique<render::ImGuiPass>(renderer_.context());
  overlay_ = pass.get();
  renderer_.add(std::move(pass));
  renderer_.setGroup({});
  resources.setOwner("");
}

void SceneRenderer::setMeasuring(bool measuring) {
  renderer_.setMeasuring(measuring);
  streamingCost_.setMeasuring(measuring);
}

void SceneRenderer::uploadFonts() { overlay_->uploadFonts(); }

render::View SceneRenderer::view(const game::Snapshot& snapshot, Size size) const {
  if (lookedFrom_) {
    render::View view = *lookedFrom_;
    view.width = size.width, view.height = size.height;
    return view;
  }
  const terrain::HeightSource* ground = land_ ? &land_->ground() : nullptr;
  const render::View view = camera_.view(snapshot, settings_->render.camera, size.width, size.height, ground);
  return leavesRoom_ ? withRoomToTheLeft(view) : view;
}

void SceneRenderer::draw(const game::Snapshot& snapshot, Size size, Streaming streaming) {
  const render::View view = this->view(snapshot, size);
  if (!eyeAdapts() || isCut(snapshot, view)) eye_.cut();
  lastView_ = view;
  lastSpawn_ = snapshot.aircraft.spawnCount;
  lastCamera_ = camera_.mode();
  lastLookedFrom_ = lookedFrom_.has_value();
  drawnSize_ = size;
  settleMs_ = 0;
  if (land_) {
    if (streaming == Streaming::settled) {
      const auto begin = std::chrono::steady_clock::now();
      land_->settle(view);
      settleMs_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    } else {
      streamingCost_.measure([&] { land_->update(view); });
      streamingCost_.endRound();
    }
  }
  const render::FrameInput input = inputOf(snapshot, view);
  if (streaming == Streaming::settled) renderer_.settle(input);
  renderer_.draw(input);
  if (!eyeAdapts()) return;
  const render::SunSettings& sun = settings_->render.sun;
  const double speed = sun.source == render::SunSource::clock ? sun.timeScale : 1;
  eye_.follow(renderer_.lightInView(), snapshot.simulatedSeconds, speed);
}

bool SceneRenderer::isCut(const game::Snapshot& snapshot, const render::View& view) const {
  constexpr double kFarthestM = 200;  // that a camera moves between two frames
  return !lastView_ || camera_.mode() != lastCamera_ || lookedFrom_.has_value() != lastLookedFrom_ ||
         snapshot.aircraft.spawnCount != lastSpawn_ ||
         glm::length(view.position - lastView_->position) > kFarthestM;
}

// Of a frame that may follow another.
render::FrameInput SceneRenderer::inputOf(const game::Snapshot& snapshot, const render::View& view) const {
  render::FrameInput input = render::gameFrame(snapshot, view, features());
  input.followsLast = setup_.framesFollow;
  const bool isCarried =
      camera_.mode() != render::CameraMode::free && snapshot.aircraft.present && !lookedFrom_;
  if (isCarried && !snapshot.aircraft.crashed) input.eyeVelocity = snapshot.aircraft.velocity;
  if (eyeAdapts()) input.adaptedLevel = eye_.level();
  return input;
}

bool SceneRenderer::updateLand(const render::View& view, Streaming streaming) {
  if (!land_) return true;
  if (streaming == Streaming::settled) {
    land_->settle(view);
  } else {
    land_->update(view);
  }
  return land_->terrain().isSettled();
}

std::optional<std::vector<float>> SceneRenderer::drawUnseen(const game::Snapshot& snapshot,
                                                            const render::View& view) {
  render::FrameInput input = inputOf(snapshot, view);  // exposed as what it is compared with
  input.followsLast = false;
  return renderer_.drawUnseen(input);
}

bool SceneRenderer::drawInset(const game::Snapshot& snapshot, const render::View& view) {
  if (switch_) return false;  // its frames have the targets
  if (land_) land_->update(view);
  render::FrameInput input = inputOf(snapshot, view);
  input.followsLast = false;
  input.isInset = true;
  input.eyeVelocity = glm::dvec3(0);
  return renderer_.drawInset(input);
}

void SceneRenderer::drawOverlays(const game::Snapshot& snapshot, Size size, std::string_view reason) {
  drawnSize_ = size;
  renderer_.drawOverlays(render::gameFrame(snapshot, view(snapshot, size), features()), reason);
}

// Frames with an aircraft, a package and a target in them: ahead; straight down, where clouds above are out
// of view and what they would veil is drawn by other programs; and from the cockpit, which fills more of the
// picture than the layer of the models takes.
std::vector<SceneRenderer::WarmUpFrame> SceneRenderer::warmUpFrames(const game::Snapshot& snapshot,
                                                                    Size size) const {
  const glm::dvec3 eye = snapshot.aircraft.position + glm::dvec3(0, 20, 0);
  render::Camera camera;
  camera.setMode(render::CameraMode::free);
  camera.setPose(eye, 0, 0, 0);  // along +x
  game::Snapshot everything = snapshot;
  everything.aircraft.present = true;
  everything.aircraft.position = eye + glm::dvec3(15, -2, 0);
  game::PackageSnapshot package;
  package.position = eye + glm::dvec3(30, -2, 5);
  package.parachuteOpen = 1;
  everything.packages = {package};
  everything.target = {.present = true, .position = eye + glm::dvec3(300, -60, 0), .radius = 50};
  const auto view = [&] {
    return camera.view(everything, settings_->render.camera, size.width, size.height);
  };
  std::vector<WarmUpFrame> frames;
  frames.push_back({everything, view()});
  camera.setPose(eye, 0, -glm::half_pi<double>(), 0);
  everything.target.position = eye - glm::dvec3(0, 100, 0);
  everything.packages[0].position = eye - glm::dvec3(0, 30, 5);
  everything.aircraft.position = eye - glm::dvec3(0, 15, 0);
  frames.push_back({everything, view()});
  camera.setMode(render::CameraMode::cockpit);
  frames.push_back({everything, view(), false});
  return frames;
}

void SceneRenderer::warmUp(const game::Snapshot& snapshot, Size size, const std::stop_token& stop) {
  for (const WarmUpFrame& frame : warmUpFrames(snapshot, size)) {
    if (stop.stop_requested()) return;
    if (land_) land_->update(frame.view);
    render::FrameInput input = inputOf(frame.snapshot, frame.view);
    input.warmsUp = true;
    renderer_.draw(input);
  }
  renderer_.clearTimes();
}

SceneRenderer::LandProgress SceneRenderer::load(const game::Snapshot& snapshot, Size size) {
  if (!land_) return {};
  const render::View view = camera_.view(snapshot, settings_->render.camera, size.width, size.height);
  const terrain::TerrainFrame& frame = land_->update(view);
  const terrain::EndlessTerrain& terrain = land_->terrain();
  return {frame.chunks.size(), terrain.statistics().chunksWanted, terrain.isSettled()};
}

std::vector<std::string> SceneRenderer::takeMessages() {
  std::vector<std::string> messages = renderer_.reloadShaders().errors;
  if (land_) {
    const std::vector<std::string> ofLand = land_->takeMessages();
    messages.insert(messages.end(), ofLand.begin(), ofLand.end());
  }
  return messages;
}

void SceneRenderer::writeTo(core::FrameStatistics& statistics, std::size_t frames) {
  renderer_.fillStatistics(statistics, frames);
  statistics.threads = 1;
  if (land_) land_->writeTo(statistics);
  if (const auto* shadows = renderer_.find<render::LandShadowPass>())
    statistics.threads += shadows->threads();
  std::vector<core::EffectStatistics> bill;
  for (const EffectDescriptor& row : *setup_.table) bill.push_back(billOf(row, statistics));
  bill.push_back(billOfFrame(statistics));
  for (core::EffectStatistics& row : bill) {  // what others have added already
    const auto added = std::ranges::find(statistics.bill, row.name, &core::EffectStatistics::name);
    if (added == statistics.bill.end()) continue;
    row.simulationMs += added->simulationMs;
    row.updateMs += added->updateMs;
  }
  statistics.bill = std::move(bill);
}

// Its own passes, and those that it has together with another effect; the map of the models' shadows is
// shared by all that cast one, and counts for the first of them.
bool SceneRenderer::owns(const EffectDescriptor& row, const std::string& part) const {
  if (!setup_.effects.contains(row.effect)) return false;
  if (part == kShadowGroup) return &row == firstCaster();
  const std::string name(scene::nameOf(row.effect));
  return part == name || part.starts_with(name + '+');
}

core::EffectStatistics SceneRenderer::billOfFrame(const core::FrameStatistics& frame) const {
  core::EffectStatistics bill;
  bill.name = kFrameRow;
  bill.on = true;
  bill.ms = frame.beginMs;
  for (const auto& [name, pass] : frame.passes) {
    const auto isOwner = [&, group = pass.group](const EffectDescriptor& row) { return owns(row, group); };
    if (!pass.skipped.empty() || std::ranges::any_of(*setup_.table, isOwner)) continue;
    bill.ms += pass.ms;
    bill.draws += pass.draws;
    bill.dispatches += pass.dispatches;
  }
  const auto add = [&](std::string_view owner) {
    const render::gl::OwnedResources held = renderer_.context().resources().ownedBy(owner);
    bill.objects += held.objects;
    bill.gpuBytes += static_cast<std::int64_t>(held.bytes);
  };
  add("");
  add(kEdgesGroup);
  if (!setup_.effects.contains(scene::Effect::hud)) add(scene::nameOf(scene::Effect::hud));
  bill.threads = 1;
  return bill;
}

core::EffectStatistics SceneRenderer::billOf(const EffectDescriptor& row,
                                             const core::FrameStatistics& frame) const {
  core::EffectStatistics bill;
  bill.name = scene::nameOf(row.effect);
  bill.on = setup_.effects.contains(row.effect);
  if (!bill.on) return bill;
  bool works = false, hasPasses = false;
  for (const auto& [name, pass] : frame.passes) {
    if (!owns(row, pass.group)) continue;
    hasPasses = true;
    if (!pass.skipped.empty()) {
      if (bill.idle.empty()) bill.idle = pass.skipped;
      continue;
    }
    works = true;
    bill.ms += pass.ms;
    bill.draws += pass.draws;
    bill.dispatches += pass.dispatches;
  }
  if (works || !hasPasses) bill.idle.clear();
  if (switch_ && !switch_->isReady && row.addPasses && !hasPasses) bill.idle = "is being made";
  const render::gl::GpuResourceTracker& resources = renderer_.context().resources();
  for (const Part& part : parts_) {
    if (part.row != &row) continue;
    const render::gl::OwnedResources held = resources.ownedBy(part.name());
    bill.objects += held.objects;
    bill.gpuBytes += static_cast<std::int64_t>(held.bytes);
    if (const auto ms = startMs_.find(part.name()); ms != startMs_.end()) bill.startMs += ms->second;
  }
  if (&row == firstCaster()) {
    const render::gl::OwnedResources held = resources.ownedBy(kShadowGroup);
    bill.objects += held.objects;
    bill.gpuBytes += static_cast<std::int64_t>(held.bytes);
  }
  if (row.effect == scene::Effect::terrain && land_) {
    bill.cpuBytes = frame.terrain.bytes;
    bill.threads = land_->workerCount();
    bill.updateMs = streamingCost_.meanMs();
  }
  const auto* shadows = renderer_.find<render::LandShadowPass>();
  if (row.effect == scene::Effect::landShadows && shadows) {
    bill.cpuBytes = static_cast<std::int64_t>(shadows->cpuBytes());
    bill.threads = shadows->threads();
  }
  if (row.effect == scene::Effect::hud && overlay_) {
    const render::gl::OwnedResources held = resources.ownedBy(bill.name);
    bill.objects += held.objects;
    bill.gpuBytes += static_cast<std::int64_t>(held.bytes);
  }
  return bill;
}

const EffectDescriptor* SceneRenderer::firstCaster() const {
  const auto found = std::ranges::find_if(parts_, [](const Part& part) { return part.castsShadow; });
  return found == parts_.end() ? nullptr : found->row;
}

}  // namespace skydrop::app
