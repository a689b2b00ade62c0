#include "app/verbs.h"
#include "app/window_game.h"

namespace skydrop::app {

int fly(const CommandLine& line) {
  WindowGame(line).run();
  return 0;
}

}  // namespace skydrop::app
