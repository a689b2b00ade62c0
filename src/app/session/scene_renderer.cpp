#include "app/session/scene_renderer.h"

#include <chrono>
#include <glm/gtc/constants.hpp>

#include "app/session/effect_table.h"
#include "skydrop/render/frame/tone_map_pass.h"
#include "skydrop/render/models/model_layer.h"

namespace skydrop::app {

SceneRenderer::SceneRenderer(render::gl::Context& context, const Setup& setup, const Settings& settings)
    : setup_(setup), settings_(&settings), renderer_(context, settings.render, setup.measuring) {
  camera_.setMode(settings.view.camera);
  renderer_.setLayer(std::make_unique<render::ModelLayer>());
  for (const EffectDescriptor& row : effectTable()) {
    if (row.addPasses && setup_.effects.contains(row.effect)) row.addPasses(*this);
  }
  renderer_.add(std::make_unique<render::ToneMapPass>(context));
}

SceneRenderer::~SceneRenderer() = default;

void SceneRenderer::apply(const SettingsChange& change) {
  if (change.touches("view.camera") && camera_.mode() != settings_->view.camera) {
    camera_.setMode(settings_->view.camera);
    if (camera_.mode() == render::CameraMode::free) freeCamera();
  }
  if (change.touches("render")) renderer_.apply(settings_->render);
  for (const EffectDescriptor& row : effectTable()) {
    if (row.apply && setup_.effects.contains(row.effect)) row.apply(*this, change);
  }
}

void SceneRenderer::freeCamera() {
  if (lastView_) camera_.standAt(*lastView_);
  camera_.setMode(render::CameraMode::free);
}

void SceneRenderer::addOverlay() {
  auto pass = std::make_unique<render::ImGuiPass>(renderer_.context());
  overlay_ = pass.get();
  renderer_.add(std::move(pass));
}

void SceneRenderer::uploadFonts() { overlay_->uploadFonts(); }

render::View SceneRenderer::view(const game::Snapshot& snapshot, Size size) const {
  const terrain::HeightSource* ground = land_ ? &land_->ground() : nullptr;
  return camera_.view(snapshot, settings_->render.camera, size.width, size.height, ground);
}

void SceneRenderer::draw(const game::Snapshot& snapshot, Size size, Streaming streaming) {
  const render::View view = this->view(snapshot, size);
  lastView_ = view;
  settleMs_ = 0;
  if (land_) {
    if (streaming == Streaming::settled) {
      const auto begin = std::chrono::steady_clock::now();
      land_->settle(view);
      settleMs_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    } else {
      land_->update(view);
    }
  }
  renderer_.draw(render::gameFrame(snapshot, view, frameFeatures(setup_.effects)));
}

void SceneRenderer::warmUp(const game::Snapshot& snapshot, Size size) {
  const glm::dvec3 eye = snapshot.aircraft.position + glm::dvec3(0, 20, 0);
  render::Camera camera;
  camera.setMode(render::CameraMode::free);
  camera.setPose(eye, 0, 0, 0);  // along +x
  game::Snapshot everything = snapshot;
  everything.aircraft.position = eye + glm::dvec3(15, -2, 0);
  game::PackageSnapshot package;
  package.position = eye + glm::dvec3(30, -2, 5);
  package.parachuteOpen = 1;
  everything.packages = {package};
  everything.target = {.present = true, .position = eye + glm::dvec3(300, -60, 0), .radius = 50};
  const auto drawFrom = [&] {
    const render::View view = camera.view(everything, settings_->render.camera, size.width, size.height);
    if (land_) land_->update(view);
    renderer_.draw(render::gameFrame(everything, view, frameFeatures(setup_.effects)));
  };
  drawFrom();
  // Straight down: clouds above are out of view, and what they would veil is drawn by other programs.
  camera.setPose(eye, 0, -glm::half_pi<double>(), 0);
  everything.target.position = eye - glm::dvec3(0, 100, 0);
  everything.packages[0].position = eye - glm::dvec3(0, 30, 5);
  everything.aircraft.position = eye - glm::dvec3(0, 15, 0);
  drawFrom();
  // From the cockpit, which fills more of the frame than the layer of the models takes.
  camera.setMode(render::CameraMode::cockpit);
  drawFrom();
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
}

}  // namespace skydrop::app
