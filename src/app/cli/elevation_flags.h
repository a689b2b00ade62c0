// The flags of elevation data and of places on the earth.
#pragma once

#include <CLI/App.hpp>

#include "app/types/command_line.h"

namespace skydrop::app {

// Outlives the parsing.
class ElevationFlags {
 public:
  // Of the verbs that fly or draw: --elevation; and, with `views`, --place and --look-at.
  void addLand(CLI::App& verb, CommandLine& line, bool views);
  // Of `skydrop elevation`.
  void addCheck(CLI::App& verb, CommandLine& line);
  // After all words: rows and camera that a place stands for. Throws core::UsageError.
  void finish(CommandLine& line, bool hasCamera) const;
};

}  // namespace skydrop::app
