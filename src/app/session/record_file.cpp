#include "app/session/record_file.h"

#include <utility>

#include "app/console/standard_output.h"
#include "skydrop/core/error.h"

namespace skydrop::app {

RecordFile::RecordFile(const std::filesystem::path& file, Existing existing)
    : file_(openOutput(file).value()) {
  std::error_code none;
  if (existing == Existing::refused && std::filesystem::is_regular_file(file, none) &&
      std::filesystem::file_size(file, none) > 0) {
    throw core::DataError(file.string(), "cannot record",
                          "the file exists and is not empty, and no record is replaced");
  }
}

void RecordFile::append(std::string_view text) {
  if (isStopped_ || text.empty()) return;
  try {
    file_.append(text);
  } catch (const core::DataError& failure) {
    stop(std::string(failure.what()) + "; the record ends here, the flight goes on");
  }
}

void RecordFile::stop(std::string reason) {
  isStopped_ = true;
  reason_ = std::move(reason);
}

std::optional<std::string> RecordFile::takeReason() { return std::exchange(reason_, std::nullopt); }

}  // namespace skydrop::app
