#include "skydrop/core/output_file.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <optional>
#include <string>
#include <utility>

namespace skydrop::core {
namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;  // as the kernel
constexpr const char* kStandardOutput = "standard output";

[[noreturn]] void fail(const fs::path& path, int error) {
  throw DataError(path.string(), "cannot write", std::strerror(error));
}

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int get() const { return number_; }
  explicit operator bool() const { return number_ >= 0; }
  int release() { return std::exchange(number_, -1); }

 private:
  int number_;
};

Descriptor openToWrite(const fs::path& path) {
  return Descriptor(::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
}

fs::path folderOf(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

// Whether the folder is the list of a process's open descriptors, and of which.
enum class DescriptorFolder { no, own, others };

DescriptorFolder descriptorFolder(const fs::path& folder) {
  std::error_code error;
  const std::string real = fs::canonical(folder, error).string();
  if (error || !real.starts_with("/proc/") || !real.ends_with("/fd")) return DescriptorFolder::no;
  const std::string own = fs::canonical("/proc/self", error).string() + "/";
  return !error && real.starts_with(own) ? DescriptorFolder::own : DescriptorFolder::others;
}

// What a path means: a descriptor that the program has, or a path without a symbolic link at its end.
struct Target {
  int descriptor = -1;
  fs::path path;
};

Target resolve(const fs::path& asked) {
  fs::path at = asked;
  for (int links = 0; links <= kMostLinks; ++links) {
    struct stat status {};
    if (::lstat(at.c_str(), &status) != 0) {
      if (errno != ENOENT) fail(asked, errno);
      return {-1, at};
    }
    if (!S_ISLNK(status.st_mode)) return {-1, at};
    const fs::path folder = folderOf(at);
    switch (descriptorFolder(folder)) {
      case DescriptorFolder::own:
        return {std::atoi(at.filename().c_str()), at};
      case DescriptorFolder::others:
        return {-1, at};  // what the link says is no path
      case DescriptorFolder::no:
        break;
    }
    std::error_code error;
    const fs::path next = fs::read_symlink(at, error);
    if (error) fail(asked, error.value());
    at = next.is_absolute() ? next : folder / next;
  }
  fail(asked, ELOOP);
}

Descriptor ownDescriptor(const fs::path& asked, int number) {
  const int flags = ::fcntl(number, F_GETFL);
  if (flags < 0) fail(asked, errno);
  if ((flags & O_ACCMODE) == O_RDONLY) fail(asked, EBADF);
  Descriptor copy(::fcntl(number, F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
  if (!copy) fail(asked, errno);
  return copy;
}

Descriptor openStream(const fs::path& asked, const fs::path& path, mode_t mode) {
  if (S_ISSOCK(mode)) throw DataError(asked.string(), "cannot write", "is a socket");
  Descriptor opened = openToWrite(path);
  if (!opened && errno == ENXIO && S_ISFIFO(mode)) {
    throw DataError(asked.string(), "cannot write", "nobody reads from this pipe");
  }
  if (!opened) fail(asked, errno);
  ::fcntl(opened.get(), F_SETFL, ::fcntl(opened.get(), F_GETFL) & ~O_NONBLOCK);
  return opened;
}

struct Temporary {
  Descriptor file{-1};
  fs::path path;
};

// A new file in the folder: of a short name, whatever the length of the target's. Without a descriptor, and
// with errno, where it cannot be made.
Temporary makeTemporary(const fs::path& folder, mode_t mode) {
  static std::atomic<unsigned> counter{0};
  while (true) {
    fs::path path =
        folder / (".skydrop-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".tmp");
    Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode));
    if (!file && errno == EEXIST) continue;  // left by a process that was killed
    return {std::move(file), std::move(path)};
  }
}

// Whether the folder takes a new file; errno where not.
bool takesFiles(const fs::path& folder) {
  const Temporary probe = makeTemporary(folder, 0600);
  if (!probe.file) return false;
  ::unlink(probe.path.c_str());
  return true;
}

// Of a folder that takes no new file, or a name that cannot be given away.
bool isForbidden(int error) {
  return error == EACCES || error == EPERM || error == EROFS || error == EBUSY || error == EXDEV;
}

// The content in full, or errno.
bool writeAll(int descriptor, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count >= 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    } else if (errno == EAGAIN) {
      pollfd ready{descriptor, POLLOUT, 0};
      ::poll(&ready, 1, -1);
    } else if (errno != EINTR) {
      return false;
    }
  }
  return true;
}

// Some file systems say only when a file is closed that there was no room.
bool isAccepted(int descriptor) {
  const int copy = ::dup(descriptor);
  return copy >= 0 && ::close(copy) == 0;
}

// Owner, group and permissions of the file that is replaced. What a group may do is not handed to another
// one.
void takeOver(const struct stat& old, int descriptor) {
  mode_t mode = old.st_mode & 0777;
  const bool owned = ::fchown(descriptor, old.st_uid, old.st_gid) == 0;
  if (!owned && ::fchown(descriptor, static_cast<uid_t>(-1), old.st_gid) != 0) {
    mode = (mode & 0707) | (mode & 0070 & ((mode & 0007) << 3));
  }
  ::fchmod(descriptor, mode);
}

// Room is reserved first, so that a full disk is known before the old content is lost.
Descriptor overwrite(const fs::path& asked, const fs::path& path, std::span<const std::byte> bytes) {
  Descriptor file = openToWrite(path);
  struct stat old {};
  if (!file || ::fstat(file.get(), &old) != 0) fail(asked, errno);
  const auto size = static_cast<off_t>(bytes.size());
  if (size > old.st_size) {
    const int error = ::posix_fallocate(file.get(), 0, size);
    if (error == ENOSPC || error == EFBIG || error == EDQUOT) {
      if (::ftruncate(file.get(), old.st_size) != 0) fail(asked, errno);
      fail(asked, error);
    }
  }
  if (!writeAll(file.get(), bytes) || ::ftruncate(file.get(), size) != 0 || !isAccepted(file.get())) {
    fail(asked, errno);
  }
  return file;
}

// Returns the new file, open at its end.
Descriptor replaceFile(const fs::path& asked, const fs::path& path, std::span<const std::byte> bytes,
                       Survives survives) {
  struct stat old {};
  const bool exists = ::stat(path.c_str(), &old) == 0;
  if (exists && S_ISDIR(old.st_mode)) throw DataError(asked.string(), "cannot write", "is a folder");
  const fs::path folder = folderOf(path);
  Temporary temporary = makeTemporary(folder, exists ? 0600 : 0666);
  if (!temporary.file) {
    if (exists && isForbidden(errno)) return overwrite(asked, path, bytes);
    fail(asked, errno);
  }
  if (exists) takeOver(old, temporary.file.get());
  const bool synced = survives == Survives::powerLoss;
  int error = 0;
  if (!writeAll(temporary.file.get(), bytes) || (synced && ::fsync(temporary.file.get()) != 0) ||
      !isAccepted(temporary.file.get()) || ::rename(temporary.path.c_str(), path.c_str()) != 0) {
    error = errno;
    ::unlink(temporary.path.c_str());
  }
  if (error != 0 && exists && isForbidden(error)) return overwrite(asked, path, bytes);
  if (error != 0) fail(asked, error);
  if (synced) {
    const Descriptor entries(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (entries) ::fsync(entries.get());
  }
  return std::move(temporary.file);
}

}  // namespace

ClosedPipe::ClosedPipe() : DataError(kStandardOutput, "cannot write", "its reader has closed it") {}

OutputFile::OutputFile(fs::path path) : path_(std::move(path)) {
  if (path_.empty()) throw DataError(path_.string(), "cannot write", "the path is empty");
  Target target;
  if (path_ == "-") {
    path_ = kStandardOutput;
    target.descriptor = STDOUT_FILENO;
  } else if (!path_.has_filename()) {
    throw DataError(path_.string(), "cannot write", "is a folder");
  } else {
    target = resolve(path_);
  }
  standardOutput_ = target.descriptor == STDOUT_FILENO;
  if (target.descriptor >= 0) {
    stream_ = true;
    descriptor_ = ownDescriptor(path_, target.descriptor).release();
    return;
  }
  struct stat status {};
  const bool exists = ::stat(target.path.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) throw DataError(path_.string(), "cannot write", "is a folder");
  if (exists && !S_ISREG(status.st_mode)) {
    stream_ = true;
    descriptor_ = openStream(path_, target.path, status.st_mode).release();
    return;
  }
  // What opens for writing without being created may be written; a missing file is reported by ENOENT.
  if (!openToWrite(target.path) && (exists || errno != ENOENT)) fail(path_, errno);
  if (!takesFiles(folderOf(target.path)) && !(exists && isForbidden(errno))) fail(path_, errno);
}

OutputFile::~OutputFile() { close(); }

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)),
      standardOutput_(other.standardOutput_),
      stream_(other.stream_),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

OutputFile& OutputFile::operator=(OutputFile&& other) noexcept {
  if (this == &other) return *this;
  close();
  path_ = std::move(other.path_);
  standardOutput_ = other.standardOutput_;
  stream_ = other.stream_;
  descriptor_ = std::exchange(other.descriptor_, -1);
  return *this;
}

void OutputFile::close() noexcept {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
}

void OutputFile::write(std::span<const std::byte> bytes, Survives survives) {
  if (stream_) return append(bytes);
  close();
  replaceFile(path_, resolve(path_).path, bytes, survives);
}

void OutputFile::append(std::span<const std::byte> bytes) {
  if (descriptor_ < 0) {
    descriptor_ = replaceFile(path_, resolve(path_).path, bytes, Survives::programEnd).release();
    return;
  }
  const off_t end = stream_ ? 0 : ::lseek(descriptor_, 0, SEEK_CUR);
  if (writeAll(descriptor_, bytes)) return;
  const int error = errno;
  if (error == EPIPE && standardOutput_) throw ClosedPipe();
  if (!stream_ && ::ftruncate(descriptor_, end) == 0) ::lseek(descriptor_, end, SEEK_SET);
  fail(path_, error);
}

void OutputFile::write(std::string_view text, Survives survives) {
  write(std::as_bytes(std::span(text.data(), text.size())), survives);
}

void OutputFile::append(std::string_view text) { append(std::as_bytes(std::span(text.data(), text.size()))); }

void requireFolder(const fs::path& folder) {
  fs::path at = folder;
  std::error_code error;
  while (!fs::exists(fs::symlink_status(at, error))) at = folderOf(at.has_filename() ? at : at.parent_path());
  const bool isThere = at == folder;
  if (!fs::is_directory(at, error)) {
    throw DataError(folder.string(), "cannot make the folder",
                    error ? error.message() : std::strerror(isThere ? EEXIST : ENOTDIR));
  }
  if (!takesFiles(at)) {
    throw DataError(folder.string(), isThere ? "cannot write" : "cannot make the folder",
                    std::strerror(errno));
  }
}

fs::path setAside(const fs::path& file) {
  for (int number = 1;; ++number) {
    fs::path aside = file;
    aside += number == 1 ? ".bad" : ".bad" + std::to_string(number);
    if (::renameat2(AT_FDCWD, file.c_str(), AT_FDCWD, aside.c_str(), RENAME_NOREPLACE) == 0) return aside;
    if (errno == EINVAL) {  // a file system that cannot promise it
      if (::access(aside.c_str(), F_OK) == 0) continue;
      if (::rename(file.c_str(), aside.c_str()) == 0) return aside;
    }
    if (errno != EEXIST) throw DataError(file.string(), "cannot be kept aside", std::strerror(errno));
  }
}

}  // namespace skydrop::core
