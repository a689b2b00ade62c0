// From words to the command line as a value. Everything that can be judged from the words alone is judged
// here: an unknown flag, a size that is none, a number out of range. Paths and values of --set are judged in
// settings/settings.h, which knows them; both throw core::UsageError (exit code 2).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/types/command_line.h"

namespace skydrop::app {

struct ParsedCommandLine {
  CommandLine commandLine;
  std::optional<std::string> answer;    // --help, --version, --list-scenes: print it and end with 0,
  std::vector<std::string> complaints;  // or, after these lines on stderr, with 1
};

ParsedCommandLine parseCommandLine(int argc, const char* const* argv);

}  // namespace skydrop::app
