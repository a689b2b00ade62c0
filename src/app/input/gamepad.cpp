#include "app/input/gamepad.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "skydrop/core/guards.h"

namespace skydrop::app {
namespace {

constexpr std::array<std::string_view, 2> kShapeNames = {"axial", "radial"};

// NaN and infinity are what the axis sends when nobody touches it.
double finite(double value, double atRest) {
  if (std::isfinite(value)) return std::clamp(value, -1.0, 1.0);
  core::countGuard(core::Guard::notFiniteControl);
  return atRest;
}

void readStick(double& x, double& y, const GamepadSettings& settings) {
  if (settings.deadZoneShape == DeadZoneShape::radial) {
    const double length = std::sqrt(x * x + y * y);
    const double wanted = withoutDeadZone(length, settings.deadZone);
    // A square stick reaches past 1 in its corners: the direction stays, each axis ends at 1.
    const double scale = length > 0 ? wanted / std::min(length, 1.0) : 0;
    x = std::clamp(x * scale, -1.0, 1.0);
    y = std::clamp(y * scale, -1.0, 1.0);
  } else {
    x = withoutDeadZone(x, settings.deadZone);
    y = withoutDeadZone(y, settings.deadZone);
  }
  x = curved(x, settings.curve);
  y = curved(y, settings.curve);
}

}  // namespace

void describe(core::SettingsVisitor& visitor, GamepadSettings& settings) {
  const core::FieldNote unheard =
      core::noteWhile([&settings] { return !settings.enabled; }, "Does nothing while the gamepad is off.");
  const auto share = [&](std::string_view name, double& value, double max, std::string_view help,
                         std::string_view aliases) {
    visitor.number(name, value,
                   {.unit = "1", .min = 0, .max = max, .help = help, .aliases = aliases, .note = unheard});
  };
  const auto invert = [&](std::string_view name, bool& value, std::string_view help) {
    visitor.flag(name, value, {.help = help, .aliases = "inverted, reverse, axis", .note = unheard});
  };
  visitor.flag("enabled", settings.enabled, {.help = "Listens to the gamepad.", .aliases = "joystick"});
  share("deadZone", settings.deadZone, 0.9,
        "How far a stick must be pushed before it does anything; more hides a worn stick.",
        "drift, joystick, sensitivity");
  visitor.choice("deadZoneShape", settings.deadZoneShape, kShapeNames,
                 {.help = "Axial: each direction of a stick has its own, which keeps roll and pitch apart. "
                          "Radial: a circle.",
                  .aliases = "joystick, circular",
                  .note = unheard});
  share("curve", settings.curve, 1, "How much finer a stick is near its centre; 0 is a straight line.",
        "sensitivity, expo, response, joystick");
  share("triggerDeadZone", settings.triggerDeadZone, 0.9,
        "How far a trigger must be pulled before it does anything.", "drift, sensitivity");
  invert("invertPitch", settings.invertPitch, "A stick pushed forward lifts the nose.");
  invert("invertRoll", settings.invertRoll, "A stick pushed to the right rolls left.");
  invert("invertYaw", settings.invertYaw, "A stick pushed to the right yaws left.");
}

void describe(core::SettingsVisitor& visitor, InputSettings& settings) {
  visitor.group("gamepad", settings.gamepad, "Sticks and triggers of a gamepad.");
}

double withoutDeadZone(double value, double deadZone) {
  const double size = std::min(std::abs(value), 1.0);
  if (!(size > deadZone)) return 0;
  return std::copysign((size - deadZone) / (1 - deadZone), value);
}

double curved(double x, double curve) { return (1 - curve) * x + curve * x * x * x; }

double GamepadReading::strength(InputCode input) const {
  const auto index = static_cast<std::size_t>(input.code);
  switch (input.device) {
    case InputCode::Device::key:
      return 0;
    case InputCode::Device::button:
      return index < buttons.size() && buttons[index] ? 1 : 0;
    case InputCode::Device::axisPositive:
      return index < axes.size() ? std::max(axes[index], 0.0) : 0;
    case InputCode::Device::axisNegative:
      return index < axes.size() ? std::max(-axes[index], 0.0) : 0;
  }
  return 0;
}

GamepadReading readingOf(const GamepadState& state, const GamepadSettings& settings) {
  GamepadReading reading;
  if (!settings.enabled) return reading;
  reading.buttons = state.buttons;
  for (const int stick : {int{pad::kLeftX}, int{pad::kRightX}}) {
    const auto at = static_cast<std::size_t>(stick);
    double x = finite(state.axes[at], 0), y = finite(state.axes[at + 1], 0);
    readStick(x, y, settings);
    reading.axes[at] = x;
    reading.axes[at + 1] = y;
  }
  for (const int trigger : {int{pad::kLeftTrigger}, int{pad::kRightTrigger}}) {
    const auto at = static_cast<std::size_t>(trigger);
    reading.axes[at] = withoutDeadZone((finite(state.axes[at], -1) + 1) / 2, settings.triggerDeadZone);
  }
  return reading;
}

}  // namespace skydrop::app
