// The flags of `skydrop lab`, but for --size and --set.
#pragma once

#include <CLI/App.hpp>

#include "app/types/command_line.h"

namespace skydrop::app {

void addLabFlags(CLI::App& verb, CommandLine& line);

// What does not go together. Throws core::UsageError.
void checkLab(const CommandLine& line);

}  // namespace skydrop::app
