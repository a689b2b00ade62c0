#include "skydrop/render/models/aircraft_pass.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <string>
#include <string_view>

#include "render/frame/visibility.h"
#include "skydrop/game/snapshot.h"
#include "skydrop/render/frame/sea_cut.h"
#include "skydrop/render/models/aircraft_lamps.h"

namespace skydrop::render {
namespace {

constexpr float kFullDeflectionRad =
    0.32f;  // of a control surface at full control: 18 degrees, as small planes have

constexpr double kMovedM = 0.2;     // that a deflected surface may leave the model's box at rest
constexpr double kPlanAreaM2 = 26;  // seen from above: wings, tail and fuselage

std::optional<std::string> whyNot(const FrameInput& frame, const Model& model) {
  if (!frame.game || !frame.game->aircraft.present) return "no aircraft";
  if (!isPotentiallyVisible(frame.view, frame.game->aircraft.position, static_cast<double>(model.radius())))
    return "the aircraft is out of view";
  return std::nullopt;
}

// Of each part that is worth it the model holds one with less detail.
enum class Detail { fine, coarse };
constexpr std::string_view kCoarseEnding = "_far";
constexpr double kCoarsePixelM = 0.02;  // a pixel that covers more does not show the difference

Detail detailAt(const View& view, const game::AircraftSnapshot& aircraft) {
  const double distance = glm::length(aircraft.position - view.position);
  return distance * view.pixelAngleRad() > kCoarsePixelM ? Detail::coarse : Detail::fine;
}

void showOnly(ModelPose& pose, const Model& model, Detail detail) {
  for (const ModelNode& node : model.nodes()) {
    if (!node.name.ends_with(kCoarseEnding)) continue;
    pose.hide(detail == Detail::fine
                  ? std::string_view(node.name)
                  : std::string_view(node.name).substr(0, node.name.size() - kCoarseEnding.size()));
  }
}

// What a crash leaves: the wing torn askew and its struts gone, the tail bent, surfaces that hang.
template <class Turn>
void breakUp(ModelPose& pose, const Turn& turn) {
  constexpr glm::vec3 across(1, 0, 0), up(0, 1, 0), along(0, 0, 1);
  turn("wing", along, 0.24f);
  turn("wing", up, 0.2f);
  turn("tail", up, -0.3f);
  turn("tail", along, 0.25f);
  turn("aileron_left", across, 0.9f);
  turn("elevator", across, 0.6f);
  turn("rudder", across, 0.5f);
  for (const char* gone : {"struts", "struts_far", "gear", "gear_far"}) pose.hide(gone);
}

ModelPose poseOf(const game::AircraftSnapshot& aircraft, const Model& model, Detail detail) {
  ModelPose pose(model);
  showOnly(pose, model, detail);
  const auto deflection = [](double control) { return static_cast<float>(control) * kFullDeflectionRad; };
  constexpr glm::vec3 hinge(1, 0, 0), shaft(0, 0, 1);
  const auto turn = [&](const std::string& part, const glm::vec3& axis, float angleRad) {
    pose.turn(part, axis, angleRad);
    pose.turn(part + std::string(kCoarseEnding), axis, angleRad);
  };
  turn("aileron_left", hinge, deflection(aircraft.controls.roll));
  turn("aileron_right", hinge, -deflection(aircraft.controls.roll));
  turn("elevator", hinge, -deflection(aircraft.controls.pitch));
  turn("rudder", hinge, deflection(aircraft.controls.yaw));
  if (aircraft.crashed) breakUp(pose, turn);
  // Clockwise, seen from behind: against the sense of +z, which points back.
  for (const char* part : {"propeller", "propeller_disc", "spinner"}) {
    turn(part, shaft, -static_cast<float>(aircraft.propellerAngleRad));
  }
  return pose;
}

}  // namespace

std::optional<std::string> AircraftPass::skipReason(const FrameInput& frame) const {
  return whyNot(frame, *model_);
}

PixelBox AircraftPass::extent(const FrameInput& frame) const {
  const game::AircraftSnapshot& aircraft = frame.game->aircraft;
  const glm::dvec3 margin(kMovedM);
  return pixelsOf(frame.view, bodyMatrix(frame.view, aircraft.position, aircraft.orientation),
                  glm::dvec3(model_->low()) - margin, glm::dvec3(model_->high()) + margin);
}

void AircraftPass::draw(FrameContext& context) {
  const game::AircraftSnapshot& aircraft = context.frame.game->aircraft;
  ModelPose pose = poseOf(aircraft, *model_, detailAt(context.frame.view, aircraft));
  pose.hide("propeller_disc");
  if (!aircraft.crashed) pose.hide("propeller");
  const bool isInside = !context.frame.isMirrored && isInsideCabin(aircraft, context.frame.view.position);
  if (!isInside) pose.hide("cockpit");
  const SeaCut cut(context);
  context.gl.api().Enable(GL_CULL_FACE);
  const auto draw = [&](const ModelLamps* lamps, const FlashLight* flash) {
    model_->draw(context.shaders, "models/model.vert", "models/model.frag", context.meshDefines,
                 bodyMatrix(context.frame.view, aircraft.position, aircraft.orientation), pose,
                 lightAt(context.resources, aircraft.position), lamps, flash);
  };
  // Lamps are placed for the eye of the scene.
  const auto* lamps = context.frame.isMirrored ? nullptr : context.resources.find<AircraftLamps>();
  const bool isLit = lamps && lamps->areSeenOnModel;
  // Those who warm up draw all: the sun may rise, a flash may come.
  const auto drawLit = [&](const FlashLight* flash) {
    if (!isLit || context.frame.warmsUp) draw(nullptr, flash);
    if (isLit) draw(&lamps->onModel, flash);
  };
  const auto* flash = context.resources.find<FlashLight>();
  if (!flash || context.frame.warmsUp) drawLit(nullptr);
  if (flash) drawLit(flash);
}

ShadowSource aircraftShadow(std::shared_ptr<const Model> model) {
  return [model = std::move(model)](const FrameInput& frame, std::vector<ShadowCaster>& casters) {
    if (!frame.game || !frame.game->aircraft.present) return;
    const game::AircraftSnapshot& aircraft = frame.game->aircraft;
    const auto parts = [&aircraft, model](const View& view, const DrawPart& draw) {
      ModelPose pose = poseOf(aircraft, *model, Detail::coarse);
      pose.hide("propeller_disc");
      pose.hide("cockpit");  // within the fuselage
      if (!aircraft.crashed) pose.hide("propeller");
      draw(*model, bodyMatrix(view, aircraft.position, aircraft.orientation), pose);
    };
    casters.push_back({aircraft.position, static_cast<double>(model->radius()), kPlanAreaM2, parts});
  };
}

std::optional<std::string> PropellerPass::skipReason(const FrameInput& frame) const {
  if (frame.game && frame.game->aircraft.crashed) return "the engine has stopped";
  return whyNot(frame, *model_);
}

void PropellerPass::draw(FrameContext& context) {
  const game::AircraftSnapshot& aircraft = context.frame.game->aircraft;
  ModelPose pose = poseOf(aircraft, *model_, Detail::fine);
  pose.showOnly("propeller_disc");
  const gl::Functions& api = context.gl.api();
  api.Enable(GL_CULL_FACE);
  api.Enable(GL_BLEND);
  api.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  context.sceneDepth.bind(Model::kFreeUnit);
  model_->draw(context.shaders, "models/model.vert", "models/propeller.frag", context.defines,
               bodyMatrix(context.frame.view, aircraft.position, aircraft.orientation), pose,
               lightAt(context.resources, aircraft.position));
}

}  // namespace skydrop::render
