#include "app/session/player_camera.h"

#include <utility>

#include "skydrop/core/fixed_step.h"

namespace skydrop::app {
namespace {

constexpr double kMetresPerStep = 120 * core::FixedStep::kStepSeconds;   // 120 m/s
constexpr double kRadiansPerStep = 1.2 * core::FixedStep::kStepSeconds;  // 1.2 rad/s

}  // namespace

render::CameraMode PlayerCamera::next(SceneRenderer& sceneRenderer) {
  sceneRenderer.camera().nextMode();
  if (sceneRenderer.camera().mode() == render::CameraMode::free) sceneRenderer.freeCamera();
  rideAgain_.reset();
  return sceneRenderer.camera().mode();
}

void PlayerCamera::follow(SceneRenderer& sceneRenderer, bool timeIsHeld) {
  render::Camera& camera = sceneRenderer.camera();
  if (timeIsHeld && camera.mode() != render::CameraMode::free) {
    rideAgain_ = camera.mode();
    sceneRenderer.freeCamera();
  } else if (!timeIsHeld && rideAgain_) {
    camera.setMode(*std::exchange(rideAgain_, std::nullopt));
  }
}

void PlayerCamera::move(render::Camera& camera, const game::Controls& controls) {
  camera.move({0, controls.yaw * kMetresPerStep, (controls.thrust - controls.brake) * kMetresPerStep});
  camera.turn(controls.roll * kRadiansPerStep, -controls.pitch * kRadiansPerStep);
}

}  // namespace skydrop::app
