#include "app/session/run_config.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <utility>

#include "app/session/flown_weather.h"
#include "app/session/land_files.h"
#include "app/session/live_weather.h"
#include "app/session/recorded_files.h"
#include "app/settings/cloud_tier.h"
#include "app/settings/mood.h"
#include "app/settings/preset_store.h"
#include "app/settings/quality_preset.h"
#include "app/settings/weather_sky.h"
#include "app/types/version.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/fixed_step.h"
#include "skydrop/forecast/forecast_of.h"

namespace skydrop::app {
namespace {

std::optional<std::filesystem::path> userFolder(const CommandLine& line) {
  if (line.userDir) return line.userDir;
  if (line.verb != Verb::fly) return std::nullopt;
  const std::filesystem::path folder = defaultUserFolder();
  return folder.empty() ? std::nullopt : std::optional(folder);
}

scene::Scene sceneOf(const CommandLine& line) {
  const std::string name = line.scene.value_or(kDefaultScene);
  if (!core::isStandardInput(name)) return scene::loadScene(name);
  return scene::parseScene(core::readTextInput(name, scene::kMostSceneBytes), core::inputName(name));
}

std::optional<std::string> sceneTextNow(const std::string& source) {
  try {
    return scene::loadScene(source).text;
  } catch (const core::DataError&) {
    return std::nullopt;  // the log has its own copy
  }
}

scene::Scene recordedScene(const game::InputLog& log, const std::string& file) {
  if (log.scene.text.empty()) {  // schema 1
    try {
      return scene::loadScene(log.scene.source);
    } catch (const core::DataError& error) {
      throw core::DataError(file, "scene", error.what());
    }
  }
  scene::Scene scene = scene::parseScene(log.scene.text, file + ": scene");
  scene.name = std::filesystem::path(log.scene.source).stem().string();
  scene.source = log.scene.source;
  return scene;
}

// A replay brings its scene, seed and settings along.
void readReplay(const std::filesystem::path& path, RunConfig& run) {
  SimulationSetup& setup = run.setup;
  const std::string file = core::inputName(path);
  game::InputLog log = game::readInputLog(path);
  setup.pilot = Pilot::replay;
  setup.replayFile = file;
  setup.scene = recordedScene(log, file);
  setup.seed = log.seed;
  if (!log.program.empty() && log.program != programName()) {
    setup.replayDoubt = "recorded by " + log.program;
    run.notes.push_back(file + ": recorded by " + log.program + ", this is " + programName() +
                        ", which may fly otherwise");
  }
  if (!log.checkpoints.empty() && !log.ended) {
    std::array<char, 32> seconds{};
    std::snprintf(seconds.data(), seconds.size(), "%.3f", core::FixedStep::secondsOf(log.stepCount()));
    run.notes.push_back(file + ": the recording was cut off after " + seconds.data() + " s");
  }
  if (const auto now = sceneTextNow(log.scene.source); now && *now != setup.scene.text) {
    run.notes.push_back(file + ": scene: " + log.scene.source +
                        " has changed since; the recorded scene is flown");
  }
  setup.replay = std::move(log);
}

using Layer = std::function<void(const core::SettingsTable&)>;

enum class When { start, flying };

// Gives `next` the values that are flown with where those are fixed.
void keepFixed(const RunConfig& run, const core::SettingsTable& next) {
  for (std::size_t i = 0; i < next.fields().size(); ++i) {
    const core::Field& flown = run.table.fields()[i];
    if (!whyFixed(run.setup, flown).empty()) next.fields()[i].set(flown.get());
  }
}

// Sets the rows; what they were comes back.
GovernedRows put(const GovernedRows& rows, const core::SettingsTable& table) {
  GovernedRows before;
  for (const auto& [path, value] : rows) {
    const core::Field& field = table.at(path);
    before.emplace_back(path, field.get());
    field.set(value);
  }
  return before;
}

bool holdsRow(const GovernedRows& rows, const std::string& path) {
  return std::ranges::any_of(rows, [&](const auto& row) { return row.first == path; });
}

// That the scene itself names.
Mood moodOf(const scene::Scene& scene) {
  Settings settings;
  applyScene(core::SettingsTable(settings), scene);
  return settings.sky.mood;
}

weather::SkyChoice skyOf(const scene::Scene& scene) {
  Settings settings;
  applyScene(core::SettingsTable(settings), scene);
  return settings.weather.sky;
}

// Throws core::DataError with the name of what the settings are from.
void requireUsableWeather(const Settings& settings, const std::string& from) {
  try {
    requireUsable(settings.weather);
  } catch (const core::RangeError& error) {
    throw core::DataError(from, "settings", error.what());
  }
}

// All settings, layer upon layer; `player` applies the player's own. All or nothing: throws core::DataError.
void compose(RunConfig& run, const scene::Scene& scene, const Layer& player, When when) {
  // Which files lie at the bottom is reported by the layers above them: first the quality, then, with its
  // preset among these layers, the tier of the clouds.
  const auto composeOver = [&](const Layer& bottom) {
    Settings candidate;
    const core::SettingsTable candidateTable(candidate);
    bottom(candidateTable);
    applyScene(candidateTable, scene);
    player(candidateTable);
    applyOverrides(candidateTable, run.overrides);
    return candidate;
  };
  const Quality quality =
      qualityFor(composeOver([](const core::SettingsTable&) {}).quality, run.softwareRenderer);
  const QualityPreset preset = readQualityPreset(quality);
  const Layer applyQuality = [&](const core::SettingsTable& table) { applyPreset(table, preset); };
  const Settings chosen = composeOver(applyQuality);
  const clouds::CloudTier tier = chosen.clouds.tier;
  const bool isScenesMood = chosen.sky.mood == moodOf(scene);
  const bool isScenesSky = chosen.weather.sky == skyOf(scene);

  Settings base;
  const core::SettingsTable baseTable(base);
  applyCloudTier(baseTable, readCloudTier(cloudTierPath(tier)));
  applyQuality(baseTable);
  if (isScenesMood) applyMood(baseTable, chosen.sky.mood);
  if (isScenesSky) applyWeatherSky(baseTable, chosen.weather.sky);
  applyScene(baseTable, scene);
  requireUsableWeather(base, scene.file.string());
  if (!isScenesSky) applyWeatherSky(baseTable, chosen.weather.sky);
  if (!isScenesMood) applyMood(baseTable, chosen.sky.mood);
  Settings own = base;
  player(core::SettingsTable(own));
  requireUsableWeather(own, "the player's settings");
  Settings all = own;
  const core::SettingsTable allTable(all);
  if (run.setup.replay) {
    // What a log does not name it was flown without.
    all.wind.movesAircraft = false;
    all.effects.on[static_cast<std::size_t>(scene::Effect::groundHandling)] = false;
    all.strips.density = 0;
    all.effects.on[static_cast<std::size_t>(scene::Effect::vegetation)] = false;
    all.effects.on[static_cast<std::size_t>(scene::Effect::places)] = false;
    if (all.effects.set().contains(scene::Effect::weather)) all.clouds.layers = {};
    applyLogged(allTable, run.setup.replay->settings, run.setup.replayFile);
  }
  applyOverrides(allTable, run.overrides);
  if (const std::string missing = scene::unmetNeed(all.effects.set()); !missing.empty())
    throw core::UsageError("effects: " + missing);
  try {
    requireUsable(all.weather);
  } catch (const core::RangeError& error) {
    throw core::UsageError(std::string("--set: ") + error.what());
  }
  run.beneath = put(run.governed, allTable);
  if (when == When::flying) keepFixed(run, allTable);

  run.quality = quality;
  run.base = base;
  run.player = own;
  run.settings = all;
  run.table.takeDefaults(run.baseTable);
}

// What the player chose so far, in their file and in the menu.
Layer ownChoices(const UserSettings& settings) {
  return [&settings](const core::SettingsTable& table) { settings.applyTo(table); };
}

// Takes over a row of the player's table: what is at its base follows that.
void choose(RunConfig& run, const std::string& path) {
  const double value = run.playerTable.at(path).get();
  const bool isBase = value == run.baseTable.at(path).get();
  run.userSettings.choose(path, isBase ? std::nullopt : std::optional(value));
}

SettingsChange changeSince(Settings before, const RunConfig& run) {
  return SettingsChange::between(core::SettingsTable(before), run.table);
}

bool holds(const std::vector<std::string>& paths, const std::string& path) {
  return std::find(paths.begin(), paths.end(), path) != paths.end();
}

// The rows that a quality, a tier or a mood takes along when it is picked.
SettingsChange rowsThatFollow(const core::SettingsTable& table, const SettingsChange& picked) {
  SettingsChange rows;
  const bool quality = picked.touches("quality");
  if (quality) rows = SettingsChange(presetPaths());
  if (picked.touches(kMoodRow)) rows.add(SettingsChange(moodPaths()));
  if (picked.touches(kWeatherSkyRow)) rows.add(SettingsChange(weatherSkyPaths(table)));
  if (!quality && !picked.touches(kCloudTierRow)) return rows;
  for (const core::Field& field : table.fields()) {
    if (belongsToCloudTier(field.path)) rows.add(field.path);
  }
  return rows;
}

// The path of what an assignment of --set sets, which may have it by a former name.
std::string pathOf(const core::SettingsTable& table, const std::string& assignment) {
  const core::Field* field = table.find(assignment.substr(0, assignment.find('=')));
  return field ? field->path : "";
}

// Whether the start of the flight lies outside of the near site's hours.
void noteHeld(const weather::Forecast& forecast, const weather::ForecastClock& clock, const std::string& file,
              RunConfig& run) {
  const weather::Held held = weather::heldAt(forecast.near, weather::utcMsAt(forecast, clock, 0));
  if (held == weather::Held::within) return;
  const bool isBefore = held == weather::Held::before;
  const std::int64_t edge = isBefore ? forecast.near.firstMs() : forecast.near.lastMs();
  run.notes.push_back(file + ": the flight begins " + (isBefore ? "before" : "after") + " its " +
                      (isBefore ? "first" : "last") + " hour, " + sky::instantText({edge}) +
                      ", whose weather is held");
}

// The weather files of the command line, of the scene, or those that a replay was flown in.
void readWeatherFiles(const CommandLine& line, RunConfig& run) {
  SimulationSetup& setup = run.setup;
  const game::InputLog* log = setup.replay ? &*setup.replay : nullptr;
  forecast::Files near = line.weatherFiles, far = line.farWeatherFiles;
  if (near.empty()) {
    near = log ? sourcesOf(log->weather) : setup.scene.weatherFiles;
    far = log ? sourcesOf(log->farWeather) : setup.scene.farWeatherFiles;
  }
  if (line.live) {
    LiveWeather live = liveWeather(*line.live, near.empty());
    if (near.empty()) near = {live.file};
    live.setup.farFiles = far;
    run.renewal = std::move(live.setup);
    setup.forecastsCome = true;
    run.notes.insert(run.notes.end(), live.notes.begin(), live.notes.end());
  }
  if (log && (log->weather.size() != near.size() || log->farWeather.size() != far.size()))
    throw core::DataError(setup.replayFile, "weather",
                          "was flown in " + std::to_string(log->weather.size() + log->farWeather.size()) +
                              " weather files, and not in the " + std::to_string(near.size() + far.size()) +
                              " that are given");
  if (near.empty()) return;
  const render::SunSettings& sun = run.settings.render.sun;
  const bool hasClock = sun.source == render::SunSource::clock;
  const forecast::FileForecast read =
      forecast::readForecast(near, far, hasClock ? std::optional(sky::Instant{sun.utcMs}) : std::nullopt);
  setup.forecast = read.forecast;
  setup.weatherRecords = recordsOf(near, read.nearDigests, log ? &log->weather : nullptr, setup.replayFile);
  setup.farWeatherRecords =
      recordsOf(far, read.farDigests, log ? &log->farWeather : nullptr, setup.replayFile);
  run.notes.insert(run.notes.end(), read.notes.begin(), read.notes.end());
  noteHeld(*read.forecast, log ? run.settings.weatherFile : forecastClock(run.settings, *read.forecast),
           core::inputName(near[0]), run);
}

// The files of the land, and the rows that follow them, under all that somebody says. Settings are composed
// again where that sets rows.
void readLandFiles(const CommandLine& line, RunConfig& run) {
  SimulationSetup& setup = run.setup;
  const game::InputLog* log = setup.replay ? &*setup.replay : nullptr;
  setup.land = openLandFiles(line, setup.scene, log, setup.replayFile);
  if (log) return;
  std::erase_if(run.overrides, [&](const std::string& set) { return holds(run.landRows, set); });
  run.landRows = rowsOfLand(setup.land, run.settings, run.table);
  if (run.landRows.empty()) return;
  run.overrides.insert(run.overrides.begin(), run.landRows.begin(), run.landRows.end());
  compose(run, setup.scene, ownChoices(run.userSettings), When::start);
}

// What --set and --preset change in a replay is flown, but not as it was recorded.
void noteOverrides(RunConfig& run) {
  for (const std::string& set : run.overrides) {
    if (!decidesSimulation(pathOf(run.table, set))) continue;
    run.setup.replayDoubt += (run.setup.replayDoubt.empty() ? "" : ", ") + ("with " + set);
    return;
  }
}

// Why what the player now asks for does not take effect in this flight.
void addRefusals(const RunConfig& run, const core::SettingsTable& before, std::vector<std::string>& reasons) {
  for (std::size_t i = 0; i < run.playerTable.fields().size(); ++i) {
    const core::Field& asked = run.playerTable.fields()[i];
    const std::string reason(whyFixed(run.setup, asked));
    if (!reason.empty() && asked.get() != before.fields()[i].get() && !holds(reasons, reason))
      reasons.push_back(reason);
  }
}

// What the menu says comes after what the command line said.
void forgetOverrides(RunConfig& run, const std::string& path) {
  std::erase_if(run.overrides, [&](const std::string& set) { return pathOf(run.table, set) == path; });
}

}  // namespace

Choices choicesOf(const RunConfig& run) {
  return {run.settings,   run.base,       run.player,  run.bindings, run.userSettings,
          run.overrides,  run.governed,   run.beneath, run.quality,  run.setup.scene,
          run.setup.seed, run.setup.land, run.landRows};
}

SettingsChange goBackTo(const Choices& choices, RunConfig& run) {
  const Settings before = run.settings;
  run.settings = choices.settings;
  run.base = choices.base;
  run.player = choices.player;
  run.bindings = choices.bindings;
  run.userSettings = choices.userSettings;
  run.overrides = choices.overrides;
  run.governed = choices.governed;
  run.beneath = choices.beneath;
  run.quality = choices.quality;
  run.setup.scene = choices.scene;
  run.setup.seed = choices.seed;
  run.setup.land = choices.land;
  run.landRows = choices.landRows;
  run.table.takeDefaults(run.baseTable);
  return changeSince(before, run);
}

CommandLine withPreset(CommandLine line) {
  if (!line.preset) return line;
  const std::filesystem::path folder = presetFolder(line.userDir.value_or(defaultUserFolder()));
  const std::vector<std::string> assignments = presetOfCommandLine(*line.preset, folder);
  line.set.insert(line.set.begin(), assignments.begin(), assignments.end());
  line.preset.reset();
  return line;
}

std::unique_ptr<RunConfig> prepareRun(const CommandLine& line) {
  auto run = std::make_unique<RunConfig>();
  SimulationSetup& setup = run->setup;
  if (line.replay) {
    readReplay(*line.replay, *run);
  } else {
    setup.scene = sceneOf(line);
    setup.seed = line.seed.value_or(setup.scene.seed);
    setup.pilot = line.autopilot ? Pilot::autopilot : Pilot::player;
  }

  run->overrides = line.set;
  run->userFolder = userFolder(line);
  if (run->userFolder) {
    run->userSettings = UserSettings(*run->userFolder);
    run->warning = run->userSettings.load();
    run->bindings = run->userSettings.bindings();
  }
  compose(*run, setup.scene, ownChoices(run->userSettings), When::start);
  if (line.replay) noteOverrides(*run);
  readLandFiles(line, *run);
  readWeatherFiles(line, *run);
  if (line.record) run->recorder = std::make_unique<FlightRecorder>(*line.record);
  setup.recorder = run->recorder.get();
  return run;
}

void useSoftwareRenderer(RunConfig& run) {
  run.softwareRenderer = true;
  compose(run, run.setup.scene, ownChoices(run.userSettings), When::start);
}

SettingsChange takeMenuChanges(RunConfig& run, const SettingsChange& picked) {
  requireUsable(run.settings.effects);
  requireUsable(run.settings.weather);
  for (const std::string& path : picked.paths()) {
    run.playerTable.at(path).set(run.table.at(path).get());
    choose(run, path);
    forgetOverrides(run, path);
  }
  const SettingsChange following = rowsThatFollow(run.table, picked);
  if (following.empty()) return picked;
  for (const std::string& path : following.paths()) {
    if (picked.touches(path)) continue;  // chosen too: a preset of the player's, a reset of everything
    run.playerTable.at(path).set(run.baseTable.at(path).get());
    choose(run, path);
    forgetOverrides(run, path);
  }
  Settings before = run.settings;
  compose(run, run.setup.scene, ownChoices(run.userSettings), When::flying);
  SettingsChange change = changeSince(before, run);
  change.add(picked);
  return change;
}

SettingsChange govern(RunConfig& run, GovernedRows rows) {
  const Settings before = run.settings;
  for (const auto& [path, value] : run.beneath) {
    if (!holdsRow(rows, path)) run.table.at(path).set(value);
  }
  std::erase_if(run.beneath, [&](const auto& row) { return !holdsRow(rows, row.first); });
  for (auto& row : put(rows, run.table)) {
    if (!holdsRow(run.beneath, row.first)) run.beneath.push_back(std::move(row));
  }
  run.governed = std::move(rows);
  return changeSince(before, run);
}

Settings ungoverned(const RunConfig& run) {
  Settings settings = run.settings;
  put(run.beneath, core::SettingsTable(settings));
  return settings;
}

namespace {

// All or nothing. `land` null: that of the run stays.
SettingsChange takeOver(RunConfig& run, const scene::Scene& scene, const LandFiles* land) {
  const Settings before = run.settings;
  const Choices whole = choicesOf(run);
  try {
    if (land != nullptr) {
      std::erase_if(run.overrides, [&](const std::string& set) { return holds(run.landRows, set); });
      compose(run, scene, ownChoices(run.userSettings), When::flying);
      run.landRows = rowsOfLand(*land, run.settings, run.table);
      run.overrides.insert(run.overrides.begin(), run.landRows.begin(), run.landRows.end());
    }
    compose(run, scene, ownChoices(run.userSettings), When::flying);
  } catch (...) {
    goBackTo(whole, run);
    throw;
  }
  if (land != nullptr) run.setup.land = *land;
  return changeSince(before, run);
}

}  // namespace

SettingsChange reloadScene(RunConfig& run, const CommandLine& line) {
  const scene::Scene scene = scene::loadScene(run.setup.scene.source);
  std::optional<LandFiles> land;
  if (namesOtherLand(line, run.setup.scene, scene))
    land = openLandFiles(line, scene, nullptr, run.setup.replayFile);
  const SettingsChange change = takeOver(run, scene, land ? &*land : nullptr);
  run.setup.scene = scene;
  if (!line.seed && !line.replay) run.setup.seed = scene.seed;
  return change;
}

SettingsChange reloadLand(RunConfig& run, const CommandLine& line) {
  const LandFiles land = openLandFiles(line, run.setup.scene, nullptr, run.setup.replayFile);
  return takeOver(run, run.setup.scene, &land);
}

SettingsChange reloadPlayer(RunConfig& run, std::vector<std::string>* refused) {
  Settings before = run.settings, playerBefore = run.player;
  UserSettings edited = run.userSettings;
  std::optional<std::string> warning = edited.reload();
  compose(run, run.setup.scene, ownChoices(edited), When::flying);
  run.bindings = mergedBindings(edited.bindings(), run.userSettings.bindings(), run.bindings);
  run.userSettings = std::move(edited);
  run.warning = std::move(warning);
  if (refused) addRefusals(run, core::SettingsTable(playerBefore), *refused);
  return changeSince(before, run);
}

}  // namespace skydrop::app
