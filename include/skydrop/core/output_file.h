// A place that results are written to. It is opened, or refused, before the work that makes them; until there
// is something to write, nothing that lies there is touched and nothing is created.
//
//   a regular file     replaced as a whole: a temporary file beside it, checked, then renamed. Symbolic links
//                      are followed and stay; permissions are kept, owner and group where the system allows.
//                      Other hard links keep the old content. Where the folder takes no new file but the file
//                      itself is writable, it is written in place, after room was reserved for it.
//   a device, a pipe   written to, in order. A named pipe needs its reader first: without one it is refused.
//   -, /dev/stdout,    the descriptor that the program already has, whoever owns what is behind it.
//   /dev/fd/N
//
// A file that may not be written is refused, even where its folder would allow to replace it. POSIX only.
// One thread at a time. Every failure is a DataError that names the path as it was asked for.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

#include "skydrop/core/error.h"

namespace skydrop::core {

// Whoever read standard output has closed it (`skydrop ... | head -1`): no failure of the program's.
class ClosedPipe : public DataError {
 public:
  ClosedPipe();
};

// What a new content survives: the end of the program, or a loss of power as well (it is on the disk before
// it takes the name; some milliseconds).
enum class Survives { programEnd, powerLoss };

class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&& other) noexcept;

  // As it was asked for; "standard output" for "-".
  const std::filesystem::path& path() const { return path_; }
  bool isStandardOutput() const { return standardOutput_; }
  // Not a regular file: what was written cannot be replaced, only followed.
  bool isStream() const { return stream_; }

  // The whole content: replaces what the file has. After a failure the old content stands.
  void write(std::span<const std::byte> bytes, Survives survives = Survives::programEnd);
  void write(std::string_view text, Survives survives = Survives::programEnd);

  // For what grows while the program runs: the first call replaces what the file has, as write() does, the
  // next ones add to it. All that was added is the system's when the call returns; an addition that fails is
  // taken back.
  void append(std::span<const std::byte> bytes);
  void append(std::string_view text);

 private:
  void close() noexcept;

  std::filesystem::path path_;
  bool standardOutput_ = false;
  bool stream_ = false;
  int descriptor_ = -1;  // of a stream, or of a file that grows
};

// Refuses a folder that files cannot be written to, or that could not be made. Makes nothing.
void requireFolder(const std::filesystem::path& folder);

// Renames a file to NAME.bad, or to the first of .bad2, .bad3, ... that is free, and returns the new name.
// Replaces nothing. Throws DataError.
std::filesystem::path setAside(const std::filesystem::path& file);

}  // namespace skydrop::core
