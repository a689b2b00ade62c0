// The flags of `skydrop weather` that are not those of a scene.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "app/types/command_line.h"

namespace skydrop::app {

// Outlives the parsing.
class WeatherFlags {
 public:
  void add(CLI::App& verb, CommandLine& line);
  // Of any verb: also what --weather and --weather-far need. Throws core::UsageError.
  void check(const CommandLine& line) const;

 private:
  void addFetch(CLI::App& verb, WeatherRequest& weather);
  void checkFetch(const WeatherRequest& request) const;

  std::vector<std::string> fetchWords_;  // flags that belong to weather fetch
};

}  // namespace skydrop::app
