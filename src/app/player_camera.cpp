#include "app/player_camera.h"

#include <utility>

#include "skydrop/core/fixed_step.h"

namespace skydrop::app {
namespace {

constexpr double kMetresPerStep = 120 * core::FixedStep::kStepSeconds;   // 120 m/s
constexpr double kRadiansPerStep = 1.2 * core::FixedStep::kStepSeconds;  // 1.2 rad/s

}  // namespace

render::CameraMode PlayerCamera::next(Stage& stage) {
  stage.camera().nextMode();
  if (stage.camera().mode() == render::CameraMode::free) stage.freeCamera();
  rideAgain_.reset();
  return stage.camera().mode();
}

void PlayerCamera::follow(Stage& stage, bool timeIsHeld) {
  render::Camera& camera = stage.camera();
  if (timeIsHeld && camera.mode() != render::CameraMode::free) {
    rideAgain_ = camera.mode();
    stage.freeCamera();
  } else if (!timeIsHeld && rideAgain_) {
    camera.setMode(*std::exchange(rideAgain_, std::nullopt));
  }
}

void PlayerCamera::move(render::Camera& camera, const game::Controls& controls) {
  camera.move({0, controls.yaw * kMetresPerStep, (controls.thrust - controls.brake) * kMetresPerStep});
  camera.turn(controls.roll * kRadiansPerStep, -controls.pitch * kRadiansPerStep);
}

}  // namespace skydrop::app
