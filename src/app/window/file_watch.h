// Notices that a file was written by somebody else. Main thread.
#pragma once

#include <filesystem>
#include <utility>

namespace skydrop::app {

class FileWatch {
 public:
  FileWatch() = default;  // watches nothing
  explicit FileWatch(std::filesystem::path file) : file_(std::move(file)) { forget(); }

  // Whether it was written since the last call. A file that was taken away was not.
  bool wasWritten() {
    std::error_code ignored;
    return time() != std::exchange(seen_, time()) && std::filesystem::exists(file_, ignored);
  }

  // After writing it oneself.
  void forget() { seen_ = time(); }

 private:
  std::filesystem::file_time_type time() const {
    std::error_code ignored;
    return std::filesystem::last_write_time(file_, ignored);
  }

  std::filesystem::path file_;
  std::filesystem::file_time_type seen_;
};

}  // namespace skydrop::app
