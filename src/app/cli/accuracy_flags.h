// The flags of `skydrop accuracy`, but for --size and --progress.
#pragma once

#include <CLI/App.hpp>

#include "app/types/command_line.h"

namespace skydrop::app {

void addAccuracyFlags(CLI::App& verb, CommandLine& line);

}  // namespace skydrop::app
