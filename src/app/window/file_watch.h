// Notices that a file was written by somebody else. Main thread.
#pragma once

#include <filesystem>
#include <utility>
#include <vector>

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

// Of several files, which may be large and are then written for a while: notices it when none was written
// since the look before.
class FilesWatch {
 public:
  FilesWatch() = default;  // watches nothing
  explicit FilesWatch(const std::vector<std::filesystem::path>& files) {
    for (const std::filesystem::path& file : files) files_.emplace_back(file);
  }

  // Whether some were written before the last call, and none since.
  bool wereWritten() {
    bool isWriting = false;
    for (FileWatch& file : files_) isWriting = file.wasWritten() || isWriting;
    return std::exchange(wasWriting_, isWriting) && !isWriting;
  }

 private:
  std::vector<FileWatch> files_;
  bool wasWriting_ = false;
};

}  // namespace skydrop::app
