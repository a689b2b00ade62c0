// The flags of `skydrop noise`, but for --seed and --size.
#pragma once

#include <CLI/App.hpp>

#include "app/cli/noise_words.h"

namespace skydrop::app {

// Outlives the parsing.
class NoiseFlags {
 public:
  void add(CLI::App& verb, CommandLine& line);
  // What --generate and --tool ask for. Throws core::UsageError.
  void finish(CommandLine& line) const;

 private:
  void addTexture(CLI::App& verb, CommandLine& line);
  void finishTool(CommandLine& line) const;

  NoiseWords words_;
};

}  // namespace skydrop::app
