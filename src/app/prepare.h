// From the command line to what a run needs: scene, settings, replay. The same for every verb.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/command_line.h"
#include "app/settings.h"
#include "app/simulation.h"

namespace skydrop::app {

// Not movable: the table refers to the settings.
struct Run {
  Run() : table(settings), baseTable(base) {}
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  Settings settings;
  core::SettingsTable table;
  Settings base;  // as they were before the player's file, --set and the menu: what is saved is the difference
  core::SettingsTable baseTable;
  SimulationSetup setup;
  std::optional<std::filesystem::path> userFolder;  // where the player's settings are kept
  std::optional<std::string> warning;               // a broken settings file, to be said once
};

// Throws core::UsageError, core::DataError.
std::unique_ptr<Run> prepareRun(const CommandLine& line);

}  // namespace skydrop::app
