#include "skydrop/core/file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#if !defined(_WIN32)
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

#include "skydrop/core/error.h"
#include "skydrop/core/output_file.h"

namespace skydrop::core {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

constexpr std::string_view kCannotOpen = "cannot open";

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view what, int error) {
  throw DataError(path.string(), what, std::strerror(error));
}

#if defined(_WIN32)

File openRegularFile(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw DataError(path.string(), kCannotOpen, "is a folder");
  File file(std::fopen(path.string().c_str(), "rb"));
  if (!file) fail(path, kCannotOpen, errno);
  return file;
}

#else

void requireRegular(const std::filesystem::path& path, const struct stat& status) {
  const auto refuse = [&](const char* reason) { throw DataError(path.string(), kCannotOpen, reason); };
  switch (status.st_mode & S_IFMT) {
    case S_IFREG:
      return;
    case S_IFDIR:
      return refuse("is a folder");
    case S_IFIFO:
      return refuse("is a pipe, not a regular file");
    case S_IFSOCK:
      return refuse("is a socket, not a regular file");
    default:
      return refuse("is a device, not a regular file");
  }
}

// Asked before opening, because opening alone can block, wake a writer or move a device; and of what was
// opened, because another file may have taken the name in between.
File openRegularFile(const std::filesystem::path& path) {
  const std::string& name = path.native();
  if (name.find('\0') != std::string::npos)
    throw DataError(name, kCannotOpen, "a zero byte cannot be in a path");
  struct stat status;
  if (::stat(name.c_str(), &status) != 0) fail(path, kCannotOpen, errno);
  requireRegular(path, status);
  const int descriptor = ::open(name.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
  if (descriptor < 0) fail(path, kCannotOpen, errno);
  File file(::fdopen(descriptor, "rb"));
  if (!file) {
    const int error = errno;
    ::close(descriptor);
    fail(path, kCannotOpen, error);
  }
  if (::fstat(descriptor, &status) != 0) fail(path, kCannotOpen, errno);
  requireRegular(path, status);
  return file;
}

#endif

// By pieces, so that files that lie about their size are read as they are.
template <class Container>
Container readAll(std::FILE* file, const std::string& name, std::size_t maxBytes) {
  Container content;
  char piece[1 << 16];
  while (true) {
    errno = 0;
    const std::size_t count = std::fread(piece, 1, sizeof piece, file);
    if (count > 0) {
      if (content.size() + count > maxBytes) {
        throw DataError(name, "too large", "more than " + std::to_string(maxBytes) + " bytes");
      }
      const std::size_t end = content.size();
      content.resize(end + count);
      std::memcpy(content.data() + end, piece, count);
    }
    if (count < sizeof piece) {
      if (std::ferror(file)) throw DataError(name, "cannot read", std::strerror(errno));
      return content;
    }
  }
}

template <class Container>
Container readInto(const std::filesystem::path& path, std::size_t maxBytes) {
  const File file = openRegularFile(path);
  return readAll<Container>(file.get(), path.string(), maxBytes);
}

template <class Container>
Container readInputInto(const std::filesystem::path& path, std::size_t maxBytes) {
  if (!isStandardInput(path)) return readInto<Container>(path, maxBytes);
  return readAll<Container>(stdin, inputName(path), maxBytes);
}

}  // namespace

std::vector<std::byte> readFile(const std::filesystem::path& path, std::size_t maxBytes) {
  return readInto<std::vector<std::byte>>(path, maxBytes);
}

std::string readFileStart(const std::filesystem::path& path, std::size_t bytes) {
  const File file = openRegularFile(path);
  std::string start(bytes, '\0');
  start.resize(std::fread(start.data(), 1, start.size(), file.get()));
  if (std::ferror(file.get())) fail(path, "cannot read", errno);
  return start;
}

std::string readTextFile(const std::filesystem::path& path, std::size_t maxBytes) {
  return readInto<std::string>(path, maxBytes);
}

bool isStandardInput(const std::filesystem::path& path) { return path == "-"; }

std::vector<std::byte> readInput(const std::filesystem::path& path, std::size_t maxBytes) {
  return readInputInto<std::vector<std::byte>>(path, maxBytes);
}

std::string readTextInput(const std::filesystem::path& path, std::size_t maxBytes) {
  return readInputInto<std::string>(path, maxBytes);
}

std::string inputName(const std::filesystem::path& path) {
  return isStandardInput(path) ? "standard input" : path.string();
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
