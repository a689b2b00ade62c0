#include "app/prepare.h"

#include "app/preset_shelf.h"
#include "app/user_settings.h"
#include "skydrop/core/error.h"

namespace skydrop::app {
namespace {

std::optional<std::filesystem::path> userFolder(const CommandLine& line) {
  if (line.userDir) return line.userDir;
  if (line.verb != Verb::fly) return std::nullopt;
  const std::filesystem::path folder = defaultUserFolder();
  return folder.empty() ? std::nullopt : std::optional(folder);
}

// A replay brings its scene, seed and settings along.
void readReplay(const std::filesystem::path& file, SimulationSetup& setup) {
  setup.pilot = Pilot::replay;
  setup.replayFile = file.string();
  setup.replay = game::readInputLog(file);
  setup.scene = scene::loadScene(setup.replay->scene);
  setup.seed = setup.replay->seed;
}

}  // namespace

CommandLine withPreset(CommandLine line) {
  if (!line.preset) return line;
  const std::filesystem::path folder = presetFolder(line.userDir.value_or(defaultUserFolder()));
  const std::vector<std::string> assignments = presetOfCommandLine(*line.preset, folder);
  line.set.insert(line.set.begin(), assignments.begin(), assignments.end());
  line.preset.reset();
  return line;
}

std::unique_ptr<Run> prepareRun(const CommandLine& line) {
  auto run = std::make_unique<Run>();
  SimulationSetup& setup = run->setup;
  if (line.replay) {
    readReplay(*line.replay, setup);
  } else {
    setup.scene = scene::loadScene(line.scene.value_or(kDefaultScene));
    setup.seed = line.seed.value_or(setup.scene.seed);
    setup.pilot = line.autopilot ? Pilot::autopilot : Pilot::player;
  }
  setup.record = line.record.has_value();

  applyScene(run->table, setup.scene);
  run->base = run->settings;
  run->userFolder = userFolder(line);
  if (run->userFolder) run->warning = loadUserSettings(run->table, run->bindings, *run->userFolder);
  run->player = run->settings;
  if (setup.replay) applyLogged(run->table, setup.replay->settings, setup.replayFile);
  applyOverrides(run->table, line.set);
  return run;
}

void reloadScene(Run& run, const CommandLine& line) {
  const scene::Scene scene = scene::loadScene(run.setup.scene.file.string());
  Settings base;
  const core::SettingsTable baseTable(base);
  applyScene(baseTable, scene);

  Settings player = base;
  const core::SettingsTable playerTable(player);
  for (std::size_t i = 0; i < playerTable.fields().size(); ++i) {
    const double chosen = run.playerTable.fields()[i].get();
    if (chosen != run.baseTable.fields()[i].get()) playerTable.fields()[i].set(chosen);
  }
  run.setup.scene = scene;
  if (!line.seed && !line.replay) run.setup.seed = scene.seed;
  run.base = base;
  run.player = player;
  run.settings = player;
  applyOverrides(run.table, line.set);
}

std::vector<std::string> reloadPlayer(Run& run, const CommandLine& line) {
  Settings player = run.base;
  const core::SettingsTable playerTable(player);
  readUserSettings(playerTable, run.bindings, *run.userFolder);
  Settings before = run.settings;
  run.player = player;
  run.settings = player;
  applyOverrides(run.table, line.set);

  const core::SettingsTable beforeTable(before);
  std::vector<std::string> changed;
  for (std::size_t i = 0; i < run.table.fields().size(); ++i) {
    if (run.table.fields()[i].get() != beforeTable.fields()[i].get())
      changed.push_back(run.table.fields()[i].path);
  }
  return changed;
}

}  // namespace skydrop::app
