// A flight as a table, for plots and for whoever tunes it: one row a step, numbers with names and units in
// the first line, separated by commas (CSV). Not for replays: an input log is.
#pragma once

#include <filesystem>
#include <string>

#include "skydrop/game/snapshot.h"

namespace skydrop::app {

class FlightTrace {
 public:
  FlightTrace();

  void append(const game::Snapshot& snapshot);
  const std::string& text() const { return text_; }
  // Throws core::DataError.
  void write(const std::filesystem::path& file) const;

 private:
  std::string text_;
};

}  // namespace skydrop::app
