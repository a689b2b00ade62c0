#include "skydrop/core/file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "skydrop/core/error.h"
#include "skydrop/core/output_file.h"

namespace skydrop::core {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view what, int error) {
  throw DataError(path.string(), what, std::strerror(error));
}

File openFile(const std::filesystem::path& path, const char* mode, std::string_view what) {
  errno = 0;
  File file(std::fopen(path.string().c_str(), mode));
  if (!file) fail(path, what, errno);
  return file;
}

template <class Container>
Container readInto(const std::filesystem::path& path, std::size_t maxBytes) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw DataError(path.string(), "cannot open", "is a folder");
  const File file = openFile(path, "rb", "cannot open");
  Container content;
  // By pieces, so that pipes and files that lie about their size are read as they are.
  char piece[1 << 16];
  while (true) {
    errno = 0;
    const std::size_t count = std::fread(piece, 1, sizeof piece, file.get());
    if (count > 0) {
      if (content.size() + count > maxBytes) {
        throw DataError(path.string(), "too large", "more than " + std::to_string(maxBytes) + " bytes");
      }
      const std::size_t end = content.size();
      content.resize(end + count);
      std::memcpy(content.data() + end, piece, count);
    }
    if (count < sizeof piece) {
      if (std::ferror(file.get())) fail(path, "cannot read", errno);
      return content;
    }
  }
}

}  // namespace

std::vector<std::byte> readFile(const std::filesystem::path& path, std::size_t maxBytes) {
  return readInto<std::vector<std::byte>>(path, maxBytes);
}

std::string readTextFile(const std::filesystem::path& path, std::size_t maxBytes) {
  return readInto<std::string>(path, maxBytes);
}

void writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  OutputFile(path).write(bytes);
}

void writeFileAtomically(const std::filesystem::path& path, std::string_view text) {
  OutputFile(path).write(text);
}

void makeFolder(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw DataError(path.string(), "cannot make the folder", error.message());
}

}  // namespace skydrop::core
