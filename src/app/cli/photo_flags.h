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
  void add(CLI::App& verb, CommandLine& line);
  // Throws core::UsageError.
  void check(const CommandLine& line) const;

 private:
  std::vector<std::string> words_;  // flags that belong to --compare
};

}  // namespace skydrop::app
