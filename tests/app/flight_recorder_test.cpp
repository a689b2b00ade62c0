#include "app/session/flight_recorder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/session/run_config.h"
#include "app/settings/user_settings.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

constexpr const char* kScene =
    R"({"schema": 1, "effects": ["aircraft"], "start": {"position": [0, 500, 0]}})";

CommandLine lineOf(const test::TemporaryFolder& folder) {
  CommandLine line;
  line.verb = Verb::simulate;
  line.userDir = folder.path() / "user";
  return line;
}

// A flight of so many steps with a moving stick, and a setting changed in its middle.
void fly(Simulation& simulation, RunConfig& run, int steps) {
  for (int i = 0; i < steps; ++i) {
    if (i == steps / 2) {
      core::setField(run.table, "aircraft.rollFactor=0.5");
      simulation.apply({"aircraft.rollFactor"});
    }
    simulation.step({.pitch = i % 300 < 40 ? 0.5 : 0.0, .roll = i % 200 < 50 ? -0.3 : 0.1});
  }
}

// Records a flight of that scene; the log's file.
std::string record(const test::TemporaryFolder& folder, const std::string& scene, int steps = 605) {
  CommandLine line = lineOf(folder);
  line.scene = scene;
  line.record = folder.path() / "flight.log";
  const auto run = prepareRun(line);
  Simulation simulation(run->setup, run->settings, run->table);
  fly(simulation, *run, steps);
  simulation.endRecording();
  EXPECT_FALSE(run->recorder->isIncomplete());
  return line.record->string();
}

struct Replayed {
  std::string divergence;
  std::vector<std::string> notes;
  std::uint64_t steps = 0;
};

Replayed replay(const std::string& log, CommandLine line) {
  line.replay = log;
  const auto run = prepareRun(line);
  Simulation simulation(run->setup, run->settings, run->table);
  while (!simulation.finished()) simulation.step({});
  return {simulation.takeDivergence().value_or(""), run->notes, simulation.world().stepCount()};
}
Replayed replay(const test::TemporaryFolder& folder, const std::string& log) {
  return replay(log, lineOf(folder));
}

void rewrite(const std::string& file, const std::string& what, const std::string& with) {
  std::string text = core::readTextFile(file);
  const auto at = text.find(what);
  ASSERT_NE(at, std::string::npos) << what << " in " << text;
  std::ofstream(file) << text.replace(at, what.size(), with);
}

TEST(FlightRecorder, aFlightReplaysThroughEveryCheckpointWhateverBecameOfItsScene) {
  // The scene lies in a folder with a blank in its name. Replayed the flight agrees; with the scene edited it
  // flies the recorded one and says so; with the scene gone it says nothing.
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "my scenes");
  const std::string scene = folder.write("my scenes/terrain.json", kScene);
  const std::string log = record(folder, scene);
  const Replayed same = replay(folder, log);
  EXPECT_EQ(same.divergence, "");
  EXPECT_TRUE(same.notes.empty()) << same.notes.front();
  EXPECT_EQ(same.steps, 605u);
  folder.write("my scenes/terrain.json", R"({"schema": 1})");
  const Replayed edited = replay(folder, log);
  EXPECT_EQ(edited.divergence, "");
  ASSERT_EQ(edited.notes.size(), 1u);
  EXPECT_EQ(edited.notes[0], log + ": scene: " + scene + " has changed since; the recorded scene is flown");
  std::filesystem::remove(scene);
  const Replayed gone = replay(folder, log);
  EXPECT_EQ(gone.divergence, "");
  EXPECT_TRUE(gone.notes.empty());
}

TEST(FlightRecorder, aLogOlderThanTheWindOfTheAircraftIsFlownInStillAir) {
  // Whatever the player has set since. A log of a flight in wind has its wind.
  const test::TemporaryFolder folder;
  const std::string log = record(folder, folder.write("a.json", kScene));
  for (const char* row : {"speed", "direction", "movesAircraft"}) {
    // With the comma before it: other rows come first.
    std::string text = core::readTextFile(log);
    const std::size_t at = text.find(std::string("[\"wind.") + row + "\",");
    ASSERT_NE(at, std::string::npos) << row;
    const std::size_t comma = text.rfind(',', at);
    std::ofstream(log) << text.erase(comma, text.find(']', at) + 1 - comma);
  }
  std::filesystem::create_directories(folder.path() / "user");
  folder.write("user/settings.json", R"({"schema": 1, "settings": {"wind": {"movesAircraft": true}}})");
  EXPECT_EQ(replay(folder, log).divergence, "");
  std::filesystem::remove(log);
  const std::string windy = record(folder, folder.path() / "a.json");
  folder.write("user/settings.json", R"({"schema": 1, "settings": {"wind": {"speed": 40}}})");
  EXPECT_EQ(replay(folder, windy).divergence, "");
  rewrite(windy, "[\"wind.speed\",\"8\"]", "[\"wind.speed\",\"9\"]");
  EXPECT_NE(replay(folder, windy).divergence, "") << "the wind decides nothing";
}

TEST(FlightRecorder, aTamperedLogNamesTheFirstCheckpointThatDiffers) {
  // A step more in the third second or at the end, another setting on the way or at the start: each is found
  // at the first checkpoint behind it.
  const auto divergence = [](const std::string& what, const std::string& with) {
    const test::TemporaryFolder folder;
    const std::string log = record(folder, folder.write("a.json", kScene));
    rewrite(log, what, with);
    const std::string line = replay(folder, log).divergence;
    return line.substr(std::min(log.size() + 2, line.size()));
  };
  EXPECT_TRUE(divergence("[\"check\",240,", "[1]\n[\"check\",240,").starts_with("step 360 (3.000 s): "));
  EXPECT_TRUE(divergence("[\"end\",605,", "[1]\n[\"end\",605,").starts_with("step 606 (5.050 s): "));
  EXPECT_TRUE(
      divergence("[\"set\",\"aircraft.rollFactor\",\"0.5\"]", "[\"set\",\"aircraft.rollFactor\",\"0.6\"]")
          .starts_with("step 360 (3.000 s): "));
  EXPECT_TRUE(divergence("[\"aircraft.rollFactor\",\"0.75\"]", "[\"aircraft.rollFactor\",\"0.7\"]")
                  .starts_with("step 0 (0.000 s): "));
}

TEST(FlightRecorder, everyStoredHashIsCompared) {
  // One hexadecimal digit of any checkpoint or of the end is enough.
  const test::TemporaryFolder folder;
  const std::string log = record(folder, folder.write("a.json", kScene), 240);
  const std::string text = core::readTextFile(log);
  std::size_t hashes = 0;
  for (const std::string kind : {"check", "end"}) {
    for (std::size_t at = text.find("[\"" + kind); at != std::string::npos;
         at = text.find("[\"" + kind, at + 1)) {
      std::string tampered = text;
      char& digit = tampered[tampered.find("\"]", at) - 1];
      digit = digit == '0' ? '1' : '0';
      std::ofstream(log) << tampered;
      EXPECT_NE(replay(folder, log).divergence, "") << at;
      ++hashes;
    }
  }
  EXPECT_EQ(hashes, 4u) << "after 0, 120, 240 steps, and the end";
}

TEST(FlightRecorder, anotherVersionAndACutLogAreSaidAndFlown) {
  const test::TemporaryFolder folder;
  const std::string log = record(folder, folder.write("a.json", kScene));
  const std::string text = core::readTextFile(log);
  std::ofstream(log) << text.substr(0, text.find("[\"check\",240,"));
  const Replayed cut = replay(folder, log);
  EXPECT_EQ(cut.divergence, "");
  ASSERT_EQ(cut.notes.size(), 1u);
  EXPECT_EQ(cut.notes[0], log + ": the recording was cut off after 2.000 s");
  EXPECT_EQ(cut.steps, 240u);
  std::ofstream(log) << text;
  rewrite(log, "\"program\":\"skydrop ", "\"program\":\"skydrop 9.");
  const Replayed other = replay(folder, log);
  EXPECT_EQ(other.divergence, "");
  ASSERT_EQ(other.notes.size(), 1u);
  EXPECT_NE(other.notes[0].find("recorded by skydrop 9."), std::string::npos) << other.notes[0];
}

TEST(FlightRecorder, aReplayWithOtherSettingsSaysThatTheyWereSet) {
  const test::TemporaryFolder folder;
  const std::string log = record(folder, folder.write("a.json", kScene));
  CommandLine line = lineOf(folder);
  line.set = {"aircraft.pitchSpeed=30"};
  const std::string said = replay(log, line).divergence;
  EXPECT_NE(said.find("step 0 "), std::string::npos) << said;
  EXPECT_NE(said.find("(with aircraft.pitchSpeed=30)"), std::string::npos) << said;
}

TEST(FlightRecorder, aLogOfSchema1IsComparedAtItsEndAndCanBeRecordedAnew) {
  // Recorded from the replay it is a log of the present schema, changes of settings included.
  const test::TemporaryFolder folder;
  const std::string scene = folder.write("a.json", kScene);
  const std::string log = record(folder, scene);
  const game::InputLog flown = game::readInputLog(log);
  const auto schema1 = [&](std::uint64_t hash) {
    std::array<char, 20> digits{};
    std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(hash));
    std::string text = R"({"schema":1,"kind":"skydrop input log","scene":")" + scene + R"(","seed":)" +
                       std::to_string(flown.seed) + R"(,"finalHash":")" + digits.data() + R"(","settings":[)";
    for (const auto& s : flown.settings) {
      text += (text.back() == '[' ? "[\"" : ",[\"") + s.path + "\",\"" + s.value + "\"]";
    }
    text += "],\"changes\":[[" + std::to_string(flown.changes.at(0).step) +
            ",\"aircraft.rollFactor\",\"0.5\"]],\"runs\":[";
    for (const auto& r : flown.runs) {
      text += (text.back() == '[' ? "[" : ",[") + std::to_string(r.steps) + ",0,0," +
              std::to_string(r.controls.pitch) + "," + std::to_string(r.controls.roll) + ",0,0]";
    }
    return text + "]}";
  };
  const std::string good = folder.write("old.log", schema1(flown.checkpoints.back().hash));
  EXPECT_EQ(replay(folder, good).divergence, "");
  CommandLine line = lineOf(folder);
  line.record = folder.path() / "new.log";
  EXPECT_EQ(replay(good, line).divergence, "");
  const game::InputLog again = game::readInputLog(*line.record);
  EXPECT_EQ(again.runs, flown.runs);
  EXPECT_EQ(again.changes, flown.changes);
  EXPECT_EQ(replay(folder, line.record->string()).divergence, "");
  const std::string bad = folder.write("bad.log", schema1(flown.checkpoints.back().hash + 1));
  EXPECT_NE(replay(folder, bad).divergence.find("step 605 "), std::string::npos);
}

TEST(FlightRecorder, aChangeThatNoStepHasSeenIsNoPartOfTheFlight) {
  // Settings are changed in a pause, before the first step and after the last, and the game is left there.
  const test::TemporaryFolder folder;
  CommandLine line = lineOf(folder);
  line.scene = folder.write("a.json", kScene);
  line.record = folder.path() / "flight.log";
  {
    const auto run = prepareRun(line);
    Simulation simulation(run->setup, run->settings, run->table);
    const auto set = [&](const std::string& assignment) {
      core::setField(run->table, assignment);
      simulation.apply({"aircraft.rollFactor"});
    };
    set("aircraft.rollFactor=0.6");
    set("aircraft.rollFactor=0.7");
    for (int i = 0; i < 130; ++i) simulation.step({.roll = 0.5});
    set("aircraft.rollFactor=0.8");
    set("aircraft.rollFactor=0.9");
    simulation.endRecording();
  }
  EXPECT_EQ(replay(folder, line.record->string()).divergence, "");
}

TEST(FlightRecorder, theFileGrowsWithEverySecondAndWithEveryFlush) {
  // Without an end, as if the program had been killed, the log holds all whole seconds; flushed, all steps.
  const test::TemporaryFolder folder;
  CommandLine line = lineOf(folder);
  line.scene = folder.write("a.json", kScene);
  line.record = folder.path() / "flight.log";
  const auto run = prepareRun(line);
  Simulation simulation(run->setup, run->settings, run->table);
  EXPECT_EQ(game::readInputLog(*line.record).stepCount(), 0u);
  for (int i = 1; i <= 500; ++i) {
    simulation.step({.roll = i % 7 * 0.1});
    ASSERT_EQ(game::readInputLog(*line.record).stepCount(), static_cast<std::uint64_t>(i / 120 * 120));
  }
  run->recorder->flush();
  EXPECT_EQ(game::readInputLog(*line.record).stepCount(), 500u);
  const Replayed cut = replay(folder, line.record->string());
  EXPECT_EQ(cut.divergence, "");
  EXPECT_EQ(cut.steps, 500u);
}

TEST(FlightRecorder, noRecordIsReplacedAndAnUnusedFileIsNotLeft) {
  const test::TemporaryFolder folder;
  const std::string kept = folder.write("kept.log", "a flight"), empty = folder.write("empty.log", "");
  const std::string line = test::refusalOf<core::DataError>([&] { FlightRecorder recorder(kept); });
  EXPECT_TRUE(line.starts_with(kept + ": cannot record: the file exists")) << line;
  EXPECT_EQ(core::readTextFile(kept), "a flight");
  const std::filesystem::path fresh = folder.path() / "fresh.log";
  { FlightRecorder recorder(fresh), onEmpty(empty); }
  EXPECT_FALSE(std::filesystem::exists(fresh));
  EXPECT_TRUE(std::filesystem::exists(empty));
  EXPECT_TRUE(test::refusalOf<core::DataError>([] {
                FlightRecorder recorder("/nowhere/a.log");
              }).starts_with("/nowhere/a.log: cannot write: "))
      << "a path is tried before the flight";
}

TEST(FlightRecorder, aFullDiskEndsTheRecordAndNotTheFlight) {
  // Said once; the flight is as long as without a record.
  const test::TemporaryFolder folder;
  CommandLine line = lineOf(folder);
  line.scene = folder.write("a.json", kScene);
  line.record = "/dev/full";
  const auto run = prepareRun(line);
  Simulation simulation(run->setup, run->settings, run->table);
  fly(simulation, *run, 300);
  simulation.endRecording();
  EXPECT_EQ(simulation.world().stepCount(), 300u);
  EXPECT_TRUE(run->recorder->isIncomplete());
  const auto reason = run->recorder->takeReason();
  ASSERT_TRUE(reason);
  EXPECT_TRUE(reason->starts_with("/dev/full: cannot write: ")) << *reason;
  EXPECT_FALSE(run->recorder->takeReason());
}

// A run of the scene with land, recorded or replayed, and what the menu and the player's file do to it.
struct FixedSettings : testing::Test {
  std::unique_ptr<app::RunConfig> start(CommandLine line) {
    line.scene = line.replay ? std::nullopt : std::optional<std::string>("terrain");
    auto run = prepareRun(line);
    simulation.emplace(run->setup, run->settings, run->table);
    return run;
  }
  // Sets the value as the menu does; the reasons why it was taken back.
  std::vector<std::string> choose(app::RunConfig& run, const std::string& path, double value) {
    core::setField(run.table.at(path), value);
    SettingsChange picked{path};
    const std::vector<std::string> reasons = simulation->takeBackFixed(picked);
    if (!picked.empty()) simulation->apply(takeMenuChanges(run, picked));
    return reasons;
  }
  std::vector<std::string> edit(app::RunConfig& run, const std::string& settings) {
    std::filesystem::create_directories(folder.path() / "user");
    folder.write("user/settings.json", R"({"schema": 1, "settings": )" + settings + "}");
    std::vector<std::string> reasons;
    simulation->apply(reloadPlayer(run, &reasons));
    return reasons;
  }

  test::TemporaryFolder folder;
  std::optional<Simulation> simulation;
};

TEST_F(FixedSettings, theLandOfARecordingStaysWhateverChangesIt) {
  // By the menu and by the player's file the change is refused with its reason, what else was changed is
  // taken; a quality that is picked moves no land. Nothing of a refused choice of the menu is kept for the
  // player.
  CommandLine line = lineOf(folder);
  line.record = folder.path() / "flight.log";
  const auto run = start(line);
  const terrain::TerrainSettings land = run->settings.terrain;
  const auto isSame = [&] {
    Settings now, then;
    now.terrain = run->settings.terrain, then.terrain = land;
    return simulationSettings(core::SettingsTable(now)) == simulationSettings(core::SettingsTable(then));
  };
  const std::string path = "terrain." + core::SettingsTable(run->settings.terrain).fields().front().path;
  const core::Field& field = run->table.at(path);
  const double other = field.get() == field.max ? field.min : field.max;
  EXPECT_EQ(choose(*run, path, other).size(), 1u);
  EXPECT_TRUE(isSame());
  EXPECT_EQ(run->playerTable.at(path).get(), run->baseTable.at(path).get());
  EXPECT_TRUE(choose(*run, "aircraft.rollFactor", 0.5).empty());
  EXPECT_EQ(run->settings.aircraft.rollFactor, 0.5);
  const std::string json = R"({"terrain": {")" + field.name + "\": " + std::to_string(other) +
                           R"(}, "aircraft": {"pitchSpeed": 22}})";
  EXPECT_EQ(edit(*run, json).size(), 1u);
  EXPECT_TRUE(isSame());
  EXPECT_EQ(run->settings.aircraft.pitchSpeed, 22);
  EXPECT_EQ(run->playerTable.at(path).get(), other) << "the file's own value is not lost";
  EXPECT_TRUE(choose(*run, "quality", static_cast<double>(Quality::low)).empty());
  EXPECT_TRUE(isSame());
}

TEST_F(FixedSettings, aReplayRepeatsTheLandingLightAndTheFlightDoesNotDependOnIt) {
  // On after half a second, off after a second, as the log says; whoever watches may switch it otherwise, and
  // the replay differs from nothing.
  CommandLine line = lineOf(folder);
  line.record = folder.path() / "light.log";
  {
    const auto run = start(line);
    const auto fly = [&](int steps) {
      for (int i = 0; i < steps; ++i) simulation->step({});
    };
    fly(60);
    EXPECT_TRUE(choose(*run, "landingLight.on", 1).empty());
    fly(60);
    EXPECT_TRUE(choose(*run, "landingLight.on", 0).empty());
    fly(60);
    simulation->endRecording();
    simulation.reset();
  }
  CommandLine again = lineOf(folder);
  again.replay = *line.record;
  const auto run = start(again);
  std::vector<bool> seen;
  while (!simulation->finished()) {
    simulation->step({});
    if (seen.empty() || seen.back() != run->settings.landingLight.on)
      seen.push_back(run->settings.landingLight.on);
    if (simulation->world().stepCount() == 150) {
      EXPECT_TRUE(choose(*run, "landingLight.on", 1).empty()) << "a picture may be looked at otherwise";
    }
  }
  EXPECT_EQ(seen, (std::vector<bool>{false, true, false, true}));
  EXPECT_EQ(simulation->takeDivergence().value_or(""), "");
}

TEST_F(FixedSettings, aReplayKeepsTheRecordedSettingsWhateverChangesThem) {
  // Also those that the log itself changed on the way: an edit of the player's file or a picked quality
  // brings neither the player's values nor those of the start back.
  const std::string log = record(folder, folder.write("a.json", kScene));
  CommandLine line = lineOf(folder);
  line.replay = log;
  const auto run = start(line);
  for (int i = 0; i < 400; ++i) simulation->step({});
  ASSERT_EQ(run->settings.aircraft.rollFactor, 0.5) << "changed by the log";
  EXPECT_EQ(choose(*run, "aircraft.rollFactor", 0.9).size(), 1u);
  EXPECT_EQ(run->settings.aircraft.rollFactor, 0.5);
  EXPECT_EQ(edit(*run, R"({"aircraft": {"rollFactor": 0.9}, "view": {"hud": false}})").size(), 1u);
  EXPECT_EQ(run->settings.aircraft.rollFactor, 0.5);
  EXPECT_FALSE(run->settings.view.hud);
  EXPECT_TRUE(choose(*run, "quality", static_cast<double>(Quality::low)).empty());
  EXPECT_EQ(run->settings.aircraft.rollFactor, 0.5);
  while (!simulation->finished()) simulation->step({});
  EXPECT_EQ(simulation->takeDivergence().value_or(""), "");
}

}  // namespace
}  // namespace skydrop::app
