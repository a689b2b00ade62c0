// A flight as a table, for plots and for whoever tunes it: one row a step, numbers with names and units in
// the first line, separated by commas (CSV). It grows on the disk with each simulated second. Not for
// replays: an input log is.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/session/record_file.h"
#include "skydrop/game/snapshot.h"

namespace skydrop::app {

class FlightTrace {
 public:
  // Replaces the file. Throws core::DataError.
  explicit FlightTrace(const std::filesystem::path& file);
  // What was flown is kept.
  ~FlightTrace() { flush(); }

  void append(const game::Snapshot& snapshot);
  void flush();

  // Whether the table holds less than the flight, and why, in one line (once).
  bool isIncomplete() const { return file_.isStopped(); }
  std::optional<std::string> takeReason() { return file_.takeReason(); }

 private:
  RecordFile file_;
  std::string rows_;  // not written yet
  int rowCount_ = 0;
};

}  // namespace skydrop::app
