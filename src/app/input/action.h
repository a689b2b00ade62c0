// What a key, a button or a stick can do. Bindings (bindings.h) say which of them does what.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace skydrop::app {

enum class Action {
  // held: they fly the aircraft (game::Controls)
  thrust,
  brake,
  rollLeft,
  rollRight,
  noseDown,
  noseUp,
  yawLeft,
  yawRight,
  drop,
  reset,
  // pressed: once a press (PlayerInput::takeActions)
  camera,
  pause,
  help,
  menu,
  mute,
  fullScreen,
  screenshot,
  freeze,
  split,
  costs,
  landingLight,
  ride,        // along with the package that fell last, and back
  deliveries,  // what came of the packages, and the best results
  weatherBar,
  weatherMode,  // live or play; this and what follows where there is weather data
  hourBack,
  hourForward,
  timeSlower,
  timeFaster,
  photo,
  escape,
  count_
};

inline constexpr std::size_t kActions = static_cast<std::size_t>(Action::count_);

// Goes into game::Controls; the others are for the program.
bool isFlightAction(Action action);

// As the settings file names it: "rollLeft".
std::string_view actionName(Action action);
std::optional<Action> actionNamed(std::string_view name);

// As the player reads it: "roll left".
std::string_view actionMeaning(Action action);

}  // namespace skydrop::app
