// From the command line to what a run needs: scene, settings, replay. The same for every verb.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/input/bindings.h"
#include "app/session/simulation.h"
#include "app/settings/governed_rows.h"
#include "app/settings/settings.h"
#include "app/settings/settings_change.h"
#include "app/settings/user_settings.h"
#include "app/types/command_line.h"
#include "skydrop/forecast/renewal.h"

namespace skydrop::app {

// Not movable: the table refers to the settings.
struct RunConfig {
  RunConfig() : table(settings), baseTable(base), playerTable(player) {}
  RunConfig(const RunConfig&) = delete;
  RunConfig& operator=(const RunConfig&) = delete;

  Settings settings;
  core::SettingsTable table;
  Settings base;  // defaults, tier, the quality's preset and the scene: what a reset goes back to
  core::SettingsTable baseTable;
  Settings player;  // base, the player's file and the menu, without --set
  core::SettingsTable playerTable;
  Bindings bindings;                   // the player's
  std::vector<std::string> overrides;  // --set, without what the menu changed since
  std::vector<std::string> landRows;   // those of them that the files of the land stand for
  // By a frame budget: over all of these, and nobody's choice; and what these rows are without it.
  GovernedRows governed, beneath;
  bool softwareRenderer = false;
  Quality quality = Quality::high;  // in force: never automatic
  SimulationSetup setup;
  std::optional<forecast::RenewalSetup> renewal;  // with --live: for whoever flies
  std::unique_ptr<FlightRecorder> recorder;       // with --record; setup.recorder
  std::vector<std::string> notes;                 // lines about a replay or weather file that leaves a doubt
  std::optional<std::filesystem::path> userFolder;  // where the player's settings are kept
  UserSettings userSettings;                        // their file, and what the menu chose since
  std::optional<std::string> warning;               // what is wrong with it, to be said once
};

// The effects that are on and have something to do.
inline scene::EffectSet effectsOf(const RunConfig& run) {
  return scene::effective(run.settings.effects.set());
}

// What a run goes by, as values: kept while they are known to work, to go back to when a change does not.
struct Choices {
  Settings settings, base, player;
  Bindings bindings;
  UserSettings userSettings;
  std::vector<std::string> overrides;
  GovernedRows governed, beneath;
  Quality quality = Quality::high;
  scene::Scene scene;
  std::uint64_t seed = 1;
  LandFiles land;
  std::vector<std::string> landRows;
};
Choices choicesOf(const RunConfig& run);
// Returns what changed by it.
SettingsChange goBackTo(const Choices& choices, RunConfig& run);

// The line with --preset spelled out as values of --set that come before the others. Names are looked up in
// the player's folder, whatever the verb: who names a preset means it. Throws core::UsageError,
// core::DataError.
CommandLine withPreset(CommandLine line);

// Opens the recording too. Throws core::UsageError, core::DataError.
std::unique_ptr<RunConfig> prepareRun(const CommandLine& line);

// The processor draws: automatic quality is low from now on. Not called by runs whose result must not depend
// on the machine. Throws core::DataError.
void useSoftwareRenderer(RunConfig& run);

// Takes over what the menu changed in `table`; it comes after --set. A quality or a tier of the clouds that
// was picked takes the rows along that its files set, whatever the player had set them to, but for rows that
// were changed together with it. Returns all that changed. Throws core::DataError; core::RangeError where an
// effect is on that rests on one that is off.
//
// In this and the two below, settings that are fixed for the flight (simulation.h) keep their values.
SettingsChange takeMenuChanges(RunConfig& run, const SettingsChange& picked);

// Puts these rows in force in place of those that a frame budget had; rows that it gives up go back to what
// they are without it. Returns what changed. Throws core::DataError.
SettingsChange govern(RunConfig& run, GovernedRows rows);

// The settings as they are without what a frame budget governs.
Settings ungoverned(const RunConfig& run);

// Reads the scene's file again, and all settings in their order of precedence; what the menu changed stays.
// Returns what changed. All or nothing: throws core::DataError and changes nothing.
SettingsChange reloadScene(RunConfig& run, const CommandLine& line);

// Opens the files of the land again, under the same names. The same.
SettingsChange reloadLand(RunConfig& run, const CommandLine& line);

// The same for the player's file; what the menu changed since it was saved stays. What does not fit is in
// `run.warning`. A change of a fixed setting waits for the next flight; its reason is added to `refused`.
SettingsChange reloadPlayer(RunConfig& run, std::vector<std::string>* refused = nullptr);

}  // namespace skydrop::app
