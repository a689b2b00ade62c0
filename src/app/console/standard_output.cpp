#include "app/console/standard_output.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstring>

namespace skydrop::app {
namespace {

bool outputIsTaken = false;  // by a file of the command line

void require(bool written, int error) {
  if (written) return;
  if (error == EPIPE) throw core::ClosedPipe();
  throw core::DataError("standard output", "cannot write", std::strerror(error));
}

}  // namespace

void prepareStandardStreams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // Opened the wrong way round, so that using it fails as it would have.
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
  std::signal(SIGPIPE, SIG_IGN);
}

void print(const char* format, ...) {
  std::FILE* to = outputIsTaken ? stderr : stdout;
  std::va_list arguments;
  va_start(arguments, format);
  errno = 0;
  const bool written = std::vfprintf(to, format, arguments) >= 0 && std::fflush(to) == 0;
  const int error = errno;
  va_end(arguments);
  if (to == stdout) require(written, error);
}

void finishStandardOutput() {
  const int copy = ::dup(STDOUT_FILENO);
  require(copy < 0 || ::close(copy) == 0, errno);
}

std::optional<core::OutputFile> openOutput(const std::optional<std::filesystem::path>& path) {
  if (!path) return std::nullopt;
  core::OutputFile file(*path);
  if (file.isStandardOutput()) {
    if (outputIsTaken) throw core::UsageError("standard output can hold one file only");
    outputIsTaken = true;
  }
  return file;
}

}  // namespace skydrop::app
