// What the player does with the camera: choose how it rides, fly it, and get off while time is held.
#pragma once

#include <optional>

#include "app/session/scene_renderer.h"
#include "skydrop/game/controls.h"

namespace skydrop::app {

class PlayerCamera {
 public:
  // Chase, cockpit, free, chase ... The free camera begins where the last frame was seen from.
  render::CameraMode next(SceneRenderer& sceneRenderer);

  // While time is held the camera is free where it was; afterwards it rides again, unless another was chosen.
  // To be called whenever time may have been held or let go.
  void follow(SceneRenderer& sceneRenderer, bool timeIsHeld);

  // One step of the clock (core::FixedStep) of the free camera, with the keys of the aircraft: thrust and
  // brake along the view, roll turns, pitch looks up and down, yaw climbs and sinks.
  static void move(render::Camera& camera, const game::Controls& controls);

 private:
  std::optional<render::CameraMode> rideAgain_;  // when time goes on
};

}  // namespace skydrop::app
