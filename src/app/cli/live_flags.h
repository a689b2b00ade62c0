// The flags of a flight in the weather of a service.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "app/types/command_line.h"

namespace skydrop::app {

// Outlives the parsing.
class LiveFlags {
 public:
  void add(CLI::App& verb, CommandLine& line);
  // Throws core::UsageError.
  void check(const CommandLine& line) const;

 private:
  std::vector<std::string> words_;  // flags that belong to --live
  bool hasProvider_ = false, hasPlace_ = false;
};

}  // namespace skydrop::app
