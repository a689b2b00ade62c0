// What the player does with keyboard and gamepad, as controls of the simulation and as actions of the
// program. Keys and buttons are on or off, a stick is not: the levers that they move (KeyAxisRamp) go
// a fixed way in every simulation step, so the same keys at the same steps give the same flight at any rate.
// Sticks and triggers are taken as they are. Both devices fly at once: their levels are added and held to the
// range, and a stick at rest adds nothing, so neither has to be chosen. Main thread.
#pragma once

#include <set>
#include <vector>

#include "app/input/bindings.h"
#include "app/input/gamepad.h"
#include "app/input/key_axis_ramp.h"
#include "skydrop/game/controls.h"
#include "skydrop/render/platform/window_context.h"

namespace skydrop::app {

// How keys move the controls. Pitch is the slowest: a full pull is 4 g, and it builds up over .8 s instead of
// hitting. Shorter is twitchy, longer is felt as lag.
inline constexpr KeyRampTimes kPitchKeys{48, 24}, kRollKeys{30, 24}, kYawKeys{36, 24}, kThrottleKeys{18, 18};
// No key takes more steps than this to full deflection.
inline constexpr int kRampSteps = 48;

// Where an axis counts as pressed when it is bound to something that is on or off, and as free again: apart,
// so that a hand that trembles presses once.
inline constexpr double kAxisPressed = 0.5, kAxisFree = 0.3;

// The buttons and directions that are pressed, from frame to frame.
class GamepadPresses {
 public:
  struct Changes {
    std::vector<InputCode> pressed, freed;
  };
  Changes update(const GamepadReading& reading);

 private:
  std::set<InputCode> down_;
};

class PlayerInput {
 public:
  explicit PlayerInput(Bindings bindings = {});

  const Bindings& bindings() const { return bindings_; }
  // Everything that is held is let go.
  void setBindings(const Bindings& bindings);

  // `typing`: a text field takes the keyboard (ImGuiInput::wantsText); presses are then not ours, releases
  // are. Everything is released when the window loses the focus: key events stay away then, and a gamepad,
  // which tells its state to any window, flies on only with the focus.
  void handle(const render::gl::WindowEvent& event, bool typing = false);

  // The gamepad in this frame; without one a reading at rest. `taken`: a menu has it; what is pressed then is
  // returned instead of done, and is not held afterwards.
  std::vector<InputCode> handle(const GamepadReading& reading, const GamepadSettings& settings,
                                bool taken = false);

  // The controls of the next simulation step; once a step. What was pressed and released between two steps is
  // on for one.
  game::Controls step();

  // Forgets what was pressed and released while no step ran (pause).
  void forgetTaps();

  // As if the action's key had been pressed.
  void act(Action action) { actions_.push_back(action); }
  // Actions of the program since the last call, in order.
  std::vector<Action> takeActions();

 private:
  void press(InputCode input);
  bool isHeld(Action action) const;
  double pushed(Action action) const;
  double pushed(Action negative, Action positive, bool inverted) const;

  Bindings bindings_;
  std::set<InputCode> held_;
  GamepadPresses gamepadPresses_;
  GamepadReading gamepad_;
  GamepadSettings gamepadSettings_;
  bool focused_ = true;
  std::vector<Action> actions_;
  std::set<InputCode> tapped_;  // pressed since the last step
  KeyAxisRamp thrust_{kThrottleKeys}, brake_{kThrottleKeys}, pitch_{kPitchKeys}, roll_{kRollKeys},
      yaw_{kYawKeys};
};

}  // namespace skydrop::app
