// A flight as a file: what the pilot did in every step, and what it takes to do it again. Seed, scene,
// settings and controls decide every bit of the simulation, so a log replayed at any frame rate ends in the
// same stateHash. The file is JSON with a schema number; equal steps in a row are one run.
#pragma once

#include <cstdint>
#include <filesystem>
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
  static constexpr std::int64_t kSchema = 1;
  static constexpr std::uint64_t kMaxSteps = 120ull * 3600 * 24;  // a day; a file that claims more is refused

  struct Run {
    std::uint64_t steps = 0;
    QuantisedControls controls;

    bool operator==(const Run&) const = default;
  };
  // A setting changed while flying (menu), applied before the step with this number (counted from 0).
  struct Change {
    std::uint64_t step = 0;
    SettingOverride setting;

    bool operator==(const Change&) const = default;
  };

  std::string program;  // name and version that recorded it
  std::string scene;    // name or file
  std::uint64_t seed = 0;
  std::vector<SettingOverride> settings;  // at the start, in order
  std::vector<Run> runs;
  std::vector<Change> changes;  // by step, ascending
  std::uint64_t finalHash = 0;  // World::stateHash after the last step; 0 where it is not known

  // Adds one step. The controls are quantised.
  void append(const Controls& controls);
  // Adds a change that takes effect before the next step that is appended.
  void appendChange(SettingOverride setting);
  std::uint64_t stepCount() const;

  bool operator==(const InputLog&) const = default;
};

// The whole file as text, and back. decode throws core::DataError that names `file`, the place (line and
// column of a syntax error, or the JSON path of a wrong value) and the reason: anything but a well-formed log
// of this schema is refused, whatever its size claims.
std::string encodeInputLog(const InputLog& log);
InputLog decodeInputLog(std::string_view text, std::string_view file);

// The same with files; core::DataError also where they cannot be read or written. "-" is read from standard
// input. Writing replaces atomically.
InputLog readInputLog(const std::filesystem::path& file);
void writeInputLog(const std::filesystem::path& file, const InputLog& log);

// Hands out a log step by step. Keeps a reference: the log outlives it.
class InputReplay {
 public:
  explicit InputReplay(const InputLog& log) : log_(&log) {}

  bool finished() const { return run_ == log_->runs.size(); }
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
};

}  // namespace skydrop::game
