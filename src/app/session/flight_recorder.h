// Records a flight as an input log (game/input_log.h) that grows on the disk: with each simulated second, and
// whenever flush() is called. Whatever ends the program, the log is valid up to there. Main thread.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "app/session/record_file.h"
#include "skydrop/game/input_log.h"

namespace skydrop::app {

class FlightRecorder {
 public:
  // Opens the file, so that a path that cannot be recorded to is refused before anything else is done. Throws
  // core::DataError: also where the file exists and is not empty.
  explicit FlightRecorder(const std::filesystem::path& file);
  // What was flown is kept, even where end() was not reached.
  ~FlightRecorder();

  // The head of the log, and the state before the first step. Once.
  void begin(const game::InputLog& start, std::uint64_t stateHash);
  void change(game::SettingOverride setting);
  void step(const game::Controls& controls);
  // Whether the steps so far should be followed by the hash of their state.
  bool checkpointIsDue() const;
  void checkpoint(std::uint64_t stateHash);
  // Writes what is still counted.
  void flush();
  void end(std::uint64_t stateHash);

  // Whether the log holds less than the flight, and why, in one line (once).
  bool isIncomplete() const { return file_.isStopped(); }
  std::optional<std::string> takeReason() { return file_.takeReason(); }

 private:
  std::string name_;
  RecordFile file_;
  std::optional<game::InputLogWriter> writer_;
};

}  // namespace skydrop::app
