// What the player does with the keyboard, as controls of the simulation and as actions of the program. Keys
// are on or off, a stick is not: levels rise and fall by a fixed share in every simulation step, so the same
// keys at the same steps give the same flight at any frame rate. Main thread.
#pragma once

#include <set>
#include <vector>

#include "app/key_map.h"
#include "skydrop/game/controls.h"
#include "skydrop/render/gl/window_context.h"

namespace skydrop::app {

// Steps of 1/120 s from centre to full deflection: 0.15 s. Shorter is twitchy, longer is felt as lag.
inline constexpr int kRampSteps = 18;

class PlayerInput {
 public:
  explicit PlayerInput(KeyMap keys = defaultKeyMap());

  const KeyMap& keys() const { return keys_; }

  // `typing`: a text field takes the keyboard (ImGuiInput::wantsText); presses are then not ours, releases
  // are. All keys are released when the window loses the focus, whose key events stay away.
  void handle(const render::gl::WindowEvent& event, bool typing = false);

  // The controls of the next simulation step; once a step. A drop or reset that was pressed and released
  // between two steps is on for one.
  game::Controls step();

  // Forgets drops and resets that were pressed while no step ran (pause).
  void forgetTaps();

  // Actions of the program since the last call, in order.
  std::vector<Action> takeActions();

 private:
  bool isHeld(Action action) const;

  KeyMap keys_;
  std::set<int> heldKeys_;
  std::vector<Action> actions_;
  bool dropTapped_ = false, resetTapped_ = false;
  int thrust_ = 0, brake_ = 0, pitch_ = 0, roll_ = 0, yaw_ = 0;  // -kRampSteps .. kRampSteps
};

}  // namespace skydrop::app
