#include "app/session/player_camera.h"

#include <gtest/gtest.h>

#include "skydrop/core/fixed_step.h"

namespace skydrop::app {
namespace {

// The free camera after a second of these keys from the origin, looking along +x.
render::Camera afterASecond(const game::Controls& controls) {
  render::Camera camera;
  camera.setPose({0, 0, 0}, 0, 0, 0);
  const auto steps = static_cast<int>(1 / core::FixedStep::kStepSeconds + 0.5);
  for (int i = 0; i < steps; ++i) PlayerCamera::move(camera, controls);
  return camera;
}

game::Controls keys(double game::Controls::*axis, double value) {
  game::Controls controls;
  controls.*axis = value;
  return controls;
}

TEST(PlayerCamera, keysOfTheAircraftMoveTheFreeCamera) {
  // Thrust and brake go 120 m along the view in a second, yaw 120 m up (rounding of 120 steps: 1e-9).
  EXPECT_NEAR(afterASecond(keys(&game::Controls::thrust, 1)).position().x, 120, 1e-9);
  EXPECT_NEAR(afterASecond(keys(&game::Controls::brake, 1)).position().x, -120, 1e-9);
  EXPECT_NEAR(afterASecond(keys(&game::Controls::yaw, 1)).position().y, 120, 1e-9);
}

TEST(PlayerCamera, rollTurnsAndPitchLooksDown) {
  // Half deflection turns 0.6 rad in a second: to the right for roll, and down for pitch as a stick does.
  EXPECT_NEAR(afterASecond(keys(&game::Controls::roll, 0.5)).yawRad(), 0.6, 1e-9);
  EXPECT_NEAR(afterASecond(keys(&game::Controls::pitch, 0.5)).pitchRad(), -0.6, 1e-9);
}

}  // namespace
}  // namespace skydrop::app
