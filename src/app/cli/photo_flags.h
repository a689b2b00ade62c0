// The flags of a photograph beside the rendered picture.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "app/types/command_line.h"

namespace skydrop::app {

// Outlives the parsing.
class PhotoFlags {
 public:
  void add(CLI::App& verb, CommandLine& line);        // of the verb that writes pictures
  void addWindow(CLI::App& verb, CommandLine& line);  // of the flight in a window
  // Throws core::UsageError.
  void check(const CommandLine& line) const;

 private:
  void addPlace(CLI::App& verb, CommandLine& line, const std::string& of);

  std::vector<std::string> words_;  // flags that belong to --compare or --photo
};

}  // namespace skydrop::app
