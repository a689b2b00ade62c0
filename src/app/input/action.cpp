#include "app/input/action.h"

namespace skydrop::app {
namespace {

struct ActionText {
  std::string_view name, meaning;
};

// In the order of the enumeration.
constexpr std::array<ActionText, kActions> kTexts = {{{"thrust", "faster"},
                                                      {"brake", "slower"},
                                                      {"rollLeft", "roll left"},
                                                      {"rollRight", "roll right"},
                                                      {"noseDown", "nose down"},
                                                      {"noseUp", "nose up"},
                                                      {"yawLeft", "yaw left"},
                                                      {"yawRight", "yaw right"},
                                                      {"drop", "drop a package"},
                                                      {"reset", "back to the start"},
                                                      {"camera", "camera"},
                                                      {"pause", "pause"},
                                                      {"help", "help"},
                                                      {"menu", "configuration"},
                                                      {"mute", "sound on, off"},
                                                      {"fullScreen", "full screen"},
                                                      {"screenshot", "screenshot"},
                                                      {"freeze", "freeze time"},
                                                      {"split", "beside a reference"},
                                                      {"costs", "what a frame costs"},
                                                      {"landingLight", "landing light"},
                                                      {"ride", "ride with the package"},
                                                      {"deliveries", "deliveries"},
                                                      {"weatherBar", "weather bar"},
                                                      {"weatherMode", "weather live or play"},
                                                      {"hourBack", "an hour back"},
                                                      {"hourForward", "an hour on"},
                                                      {"timeSlower", "time slower"},
                                                      {"timeFaster", "time faster"},
                                                      {"photo", "photograph"},
                                                      {"escape", "resume, quit"}}};

const ActionText& textOf(Action action) { return kTexts[static_cast<std::size_t>(action)]; }

}  // namespace

bool isFlightAction(Action action) { return action <= Action::reset; }

std::string_view actionName(Action action) { return textOf(action).name; }

std::string_view actionMeaning(Action action) { return textOf(action).meaning; }

std::optional<Action> actionNamed(std::string_view name) {
  for (std::size_t i = 0; i < kActions; ++i) {
    if (kTexts[i].name == name) return static_cast<Action>(i);
  }
  return std::nullopt;
}

}  // namespace skydrop::app
