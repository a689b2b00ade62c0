// A record of a flight on the disk while it is flown: a log, a trace. A record that cannot be written any
// further (a full disk) does not end the flight: it stops, and the reason is told once. Main thread.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "skydrop/core/output_file.h"

namespace skydrop::app {

class RecordFile {
 public:
  enum class Existing { replaced, refused };  // a file that is there and not empty

  // Nothing is written yet. Throws core::DataError.
  RecordFile(const std::filesystem::path& file, Existing existing);

  void append(std::string_view text);
  // Nothing is appended from now on.
  void stop(std::string reason);

  bool isStopped() const { return isStopped_; }
  // Why it stopped, in one line; once.
  std::optional<std::string> takeReason();

 private:
  core::OutputFile file_;
  bool isStopped_ = false;
  std::optional<std::string> reason_;
};

}  // namespace skydrop::app
