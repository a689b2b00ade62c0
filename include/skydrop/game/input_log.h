// A flight as a file: what the pilot did in every step, and what it takes to do it again. Seed, scene,
// settings and controls decide every bit of the simulation, so a log replayed at any frame rate passes
// through the same stateHash at every checkpoint.
//
// Schema 2 is JSON Lines, so that a log can grow while flying and is valid wherever it was cut off: a last
// line without its line feed is ignored. The first line is the header, each other line one record:
//
//   {"schema":2,"kind":"skydrop input log","program":"skydrop 0.1.0","seed":1,
//    "scene":{"source":"fair","digest":"0123456789abcdef","text":"{...}"},"settings":[["aircraft.mass","1"],...]}
// A flight in weather from files has ,"weather":[["/.../bern.json","0123456789abcdef"],..] after its scene,
// the near site's files, and "farWeather", the same of the far one.
//
//   [30,127,0,-64,0,0,1]                  so many steps with thrust, brake, pitch, roll, yaw (127 is 1) and
//                                         flags: 1 for drop + 2 for reset
//   [120]                                 more steps with the controls of the last such row
//   ["set","aircraft.maxThrottle","250"]  a setting changed before the next step
//   ["check",120,"0123456789abcdef"]      World::stateHash after so many steps from the start
//   ["end",150,"0123456789abcdef"]        the last line of a recording that was ended and not cut off
//
// "schema" is the first member of the header. Schema 1 (one JSON object, the scene by name or file, one hash
// at the end) is still read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/game/controls.h"

namespace skydrop::game {

// One --set: the setting's path and its value as text.
struct SettingOverride {
  std::string path;
  std::string value;

  bool operator==(const SettingOverride&) const = default;
};

struct InputLog {
  static constexpr std::int64_t kSchema = 2;
  // A file that claims more is refused, and no recording grows beyond it.
  static constexpr std::uint64_t kMaxSteps = 120ull * 3600 * 24;  // a day
  static constexpr std::size_t kMaxSettings = 10000;              // at the start
  static constexpr std::size_t kMaxChanges = 1000000;
  static constexpr std::size_t kMaxText = 4096;                       // bytes of a path, a value, a name
  static constexpr std::size_t kMaxSceneText = std::size_t{1} << 20;  // bytes: what a scene file may hold
  static constexpr std::size_t kMaxBytes = std::size_t{320} << 20;    // a day of rows of 30 bytes, and a bit

  // Steps are counted from 0, the start of the flight.
  struct Run {
    std::uint64_t steps = 0;
    QuantisedControls controls;

    bool operator==(const Run&) const = default;
  };
  // A setting changed while flying (menu), applied before the step with this number.
  struct Change {
    std::uint64_t step = 0;
    SettingOverride setting;

    bool operator==(const Change&) const = default;
  };
  // What World::stateHash was after so many steps.
  struct Checkpoint {
    std::uint64_t step = 0;
    std::uint64_t hash = 0;

    bool operator==(const Checkpoint&) const = default;
  };
  struct SceneRecord {
    std::string source;  // what --scene would take: a name of assets/scenes, or a file
    std::string text;    // the content of the scene file; of schema 1 empty: it has the source only

    bool operator==(const SceneRecord&) const = default;
  };

  // A weather file that was flown in; the log holds its digest and not its content.
  struct WeatherRecord {
    std::string source;        // its absolute path
    std::uint64_t digest = 0;  // of its content (forecast::contentDigest)

    bool operator==(const WeatherRecord&) const = default;
  };

  std::string program;  // name and version that recorded it
  SceneRecord scene;
  static constexpr std::size_t kMaxWeatherFiles = 100;
  std::vector<WeatherRecord> weather, farWeather;  // of the near site and of the far one, in order
  static constexpr std::size_t kMaxElevationFiles = 1000;
  std::vector<WeatherRecord> elevation;  // files of elevation data, in order
  std::uint64_t seed = 0;
  std::vector<SettingOverride> settings;  // at the start, in order
  std::vector<Run> runs;                  // neighbours differ
  std::vector<Change> changes;            // by step, ascending
  std::vector<Checkpoint> checkpoints;    // by step, ascending
  bool ended = false;  // the last checkpoint is the end of the recording; else it was cut off

  // Adds steps. The controls are quantised.
  void append(const Controls& controls) { append(quantise(controls), 1); }
  void append(const QuantisedControls& controls, std::uint64_t steps);
  // Adds a change that takes effect before the next step that is appended.
  void appendChange(SettingOverride setting);
  // Adds what the state's hash is after the steps appended so far.
  void appendCheckpoint(std::uint64_t hash) { checkpoints.push_back({stepCount(), hash}); }
  std::uint64_t stepCount() const;

  bool operator==(const InputLog&) const = default;
};

// The text of a log, piece by piece while it is flown. Knows no file. A change of a setting is written with
// the next step: of several before one step only the last of each path counts.
class InputLogWriter {
 public:
  // Takes program, scene, seed and settings from `start`.
  explicit InputLogWriter(const InputLog& start);

  void append(const QuantisedControls& controls, std::uint64_t steps);
  void change(SettingOverride setting);
  void checkpoint(std::uint64_t hash);
  void end(std::uint64_t hash);

  std::uint64_t stepCount() const { return steps_; }
  // Whether one more step would be refused by the reader.
  bool isFull() const;

  // The lines since the last call. Steps that are being counted become a line of their own.
  std::string take();

 private:
  void writeWeather(std::string_view name, const std::vector<InputLog::WeatherRecord>& files);
  void writeRun();
  void writeHash(std::string_view kind, std::uint64_t hash);

  std::string text_;
  std::uint64_t steps_ = 0;
  std::size_t changeCount_ = 0;
  InputLog::Run run_;                                 // being counted
  std::optional<QuantisedControls> writtenControls_;  // of the last row
  std::vector<SettingOverride> changes_;              // for the next step
};

// The whole file as text, and back. decode throws core::DataError that names `file`, the place (the line, or
// the JSON path in schema 1) and the reason: anything but a well-formed log is refused, whatever its size
// claims.
std::string encodeInputLog(const InputLog& log);
InputLog decodeInputLog(std::string_view text, std::string_view file);

// The digest that a log keeps of its scene's text.
std::uint64_t sceneDigest(std::string_view text);

// Of a file, or of standard input ("-"); core::DataError also where it cannot be read.
InputLog readInputLog(const std::filesystem::path& file);

// Hands out a log step by step. Keeps a reference: the log outlives it.
class InputReplay {
 public:
  explicit InputReplay(const InputLog& log) : log_(&log) {}

  bool finished() const { return run_ == log_->runs.size(); }
  // The hash that the state should have now, where the log has a checkpoint after the steps handed out so
  // far; each is handed out once.
  std::optional<std::uint64_t> hashDue();
  // The settings to change before the next step; each is handed out once.
  std::vector<SettingOverride> changesDue();
  // The controls of the next step; neutral ones after the end.
  Controls next();

 private:
  const InputLog* log_;
  std::size_t run_ = 0;
  std::uint64_t withinRun_ = 0;
  std::uint64_t step_ = 0;
  std::size_t change_ = 0;
  std::size_t checkpoint_ = 0;
};

}  // namespace skydrop::game
