#include "app/cli/verbs.h"
#include "app/window/window_game.h"

namespace skydrop::app {

int fly(const CommandLine& line) { return WindowGame(line).run(); }

}  // namespace skydrop::app
