// The noise tool in its window, and a frame of it without one. Main thread.
#pragma once

#include "app/types/command_line.h"

namespace skydrop::app {

// Until the window is closed. Throws core::GraphicsUnavailable.
void runNoiseTool(const CommandLine& line);

// A frame with the finished texture, to the file that the command line names.
void drawNoiseTool(const CommandLine& line);

}  // namespace skydrop::app
