// The noise tool in its window, and a frame of it without one. Main thread.
#pragma once

#include "app/types/command_line.h"

namespace skydrop::app {

// Until the window is closed. "Use in the sky" flies under what it shows, and comes back when the flight
// ends. Throws core::GraphicsUnavailable, and in a flight what WindowGame throws.
void runNoiseTool(const CommandLine& line);

// A frame with the finished texture, to the file that the command line names.
void drawNoiseTool(const CommandLine& line);

}  // namespace skydrop::app
