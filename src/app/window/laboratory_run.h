// The laboratory in its window. Main thread.
#pragma once

#include "app/types/command_line.h"

namespace skydrop::app {

// Until the window is closed or a signal asks the game to end. Another window may be open meanwhile: its
// context and interface have to be made current again. Begins with the page and knobs of the command line.
// Throws core::GraphicsUnavailable, core::RangeError.
void runLaboratory(const CommandLine& line);

}  // namespace skydrop::app
