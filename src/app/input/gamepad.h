// A gamepad as plain data, and what its sticks mean: dead zone, response curve, inversion.
#pragma once

#include <array>

#include "app/input/input_code.h"
#include "skydrop/core/settings.h"

namespace skydrop::app {

// As GLFW's mappings give it. Sticks -1 .. 1, right and down positive; triggers -1 (free) .. 1. A device may
// send anything, NaN included.
struct GamepadState {
  std::array<bool, pad::kButtons> buttons{};
  std::array<float, pad::kAxes> axes{0, 0, 0, 0, -1, -1};

  bool operator==(const GamepadState&) const = default;
};

enum class DeadZoneShape { axial, radial };

struct GamepadSettings {
  bool enabled = true;
  double deadZone = 0.12;  // share of the way
  DeadZoneShape deadZoneShape = DeadZoneShape::axial;
  double curve = 0.4;
  double triggerDeadZone = 0.05;
  bool invertPitch = false, invertRoll = false, invertYaw = false;
};

struct InputSettings {
  GamepadSettings gamepad;
};

void describe(core::SettingsVisitor& visitor, GamepadSettings& settings);
void describe(core::SettingsVisitor& visitor, InputSettings& settings);

// 0 up to the dead zone, from there on linear to 1 at the end: nothing jumps where the dead zone ends. Odd;
// |value| > 1 counts as 1. deadZone in [0, 1).
double withoutDeadZone(double value, double deadZone);

// (1 - curve) x + curve x^3: finer near the centre, full deflection kept. Odd and never falling for x in
// [-1, 1], curve in [0, 1].
double curved(double x, double curve);

// Axes after dead zone and curve: sticks -1 .. 1, triggers 0 .. 1. An axis that is not finite counts as free
// (Guard::notFiniteControl). Inversion belongs to what an axis is bound to (PlayerInput).
struct GamepadReading {
  std::array<bool, pad::kButtons> buttons{};
  std::array<double, pad::kAxes> axes{};

  // How far the input is pushed or pressed, 0 .. 1; 0 for keys.
  double strength(InputCode input) const;
};

GamepadReading readingOf(const GamepadState& state, const GamepadSettings& settings);

}  // namespace skydrop::app
