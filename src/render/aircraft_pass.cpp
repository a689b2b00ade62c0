#include "skydrop/render/aircraft_pass.h"

#include <cmath>
#include <glm/trigonometric.hpp>

#include "render/model/visibility.h"

namespace skydrop::render {
namespace {

constexpr float kFullDeflectionRad =
    0.32f;  // of a control surface at full control: 18 degrees, as small planes have

constexpr double kPlanAreaM2 = 26;  // seen from above: wings, tail and fuselage

// The cabin in body axes, m: within these, the eye is inside the fuselage of airplane.glb.
constexpr glm::dvec3 kCabinLow{-0.57, -0.6, -1.3}, kCabinHigh{0.57, 1.05, 1.5};

bool isInsideCabin(const FrameInput& frame) {
  const game::AircraftSnapshot& aircraft = frame.snapshot.aircraft;
  const glm::dvec3 eye = glm::conjugate(aircraft.orientation) * (frame.view.position - aircraft.position);
  return glm::all(glm::greaterThan(eye, kCabinLow)) && glm::all(glm::lessThan(eye, kCabinHigh));
}

std::optional<std::string> whyNot(const FrameInput& frame, const Model& model) {
  if (!frame.snapshot.aircraft.present) return "no aircraft";
  if (!maySee(frame.view, frame.snapshot.aircraft.position, static_cast<double>(model.radius())))
    return "the aircraft is out of view";
  return std::nullopt;
}

ModelPose poseOf(const game::AircraftSnapshot& aircraft, const Model& model) {
  ModelPose pose(model);
  const auto deflection = [](double control) { return static_cast<float>(control) * kFullDeflectionRad; };
  constexpr glm::vec3 hinge(1, 0, 0), shaft(0, 0, 1);
  pose.turn("aileron_left", hinge, deflection(aircraft.controls.roll));
  pose.turn("aileron_right", hinge, -deflection(aircraft.controls.roll));
  pose.turn("elevator", hinge, -deflection(aircraft.controls.pitch));
  pose.turn("rudder", hinge, deflection(aircraft.controls.yaw));
  // Clockwise, seen from behind: against the sense of +z, which points back.
  for (const char* part : {"propeller", "propeller_disc", "spinner"}) {
    pose.turn(part, shaft, -static_cast<float>(aircraft.propellerAngleRad));
  }
  return pose;
}

}  // namespace

std::optional<std::string> AircraftPass::idleReason(const FrameInput& frame) const {
  return whyNot(frame, *model_);
}

void AircraftPass::draw(FrameContext& context) {
  const game::AircraftSnapshot& aircraft = context.frame.snapshot.aircraft;
  ModelPose pose = poseOf(aircraft, *model_);
  pose.hide("propeller_disc");
  if (!aircraft.crashed) pose.hide("propeller");
  if (!isInsideCabin(context.frame)) pose.hide("cockpit");
  context.gl.api().Enable(GL_CULL_FACE);
  model_->draw(context.shaders, "models/model.vert", "models/model.frag", context.defines,
               bodyMatrix(context.frame.view, aircraft.position, aircraft.orientation), pose);
}

ShadowSource aircraftShadow(std::shared_ptr<const Model> model) {
  return [model = std::move(model)](const game::Snapshot& snapshot, std::vector<ShadowCaster>& casters) {
    const game::AircraftSnapshot& aircraft = snapshot.aircraft;
    if (!aircraft.present) return;
    const auto parts = [&aircraft, model](const View& view, const DrawPart& draw) {
      ModelPose pose = poseOf(aircraft, *model);
      pose.hide("propeller_disc");
      pose.hide("cockpit");  // within the fuselage
      if (!aircraft.crashed) pose.hide("propeller");
      draw(*model, bodyMatrix(view, aircraft.position, aircraft.orientation), pose);
    };
    casters.push_back({aircraft.position, static_cast<double>(model->radius()), kPlanAreaM2, parts});
  };
}

std::optional<std::string> PropellerPass::idleReason(const FrameInput& frame) const {
  if (frame.snapshot.aircraft.crashed) return "the engine has stopped";
  return whyNot(frame, *model_);
}

void PropellerPass::draw(FrameContext& context) {
  const game::AircraftSnapshot& aircraft = context.frame.snapshot.aircraft;
  ModelPose pose = poseOf(aircraft, *model_);
  pose.showOnly("propeller_disc");
  const gl::Functions& api = context.gl.api();
  api.Enable(GL_CULL_FACE);
  api.Enable(GL_BLEND);
  api.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  context.sceneDepth.bind(Model::kFreeUnit);
  model_->draw(context.shaders, "models/model.vert", "models/propeller.frag", context.defines,
               bodyMatrix(context.frame.view, aircraft.position, aircraft.orientation), pose);
}

}  // namespace skydrop::render
