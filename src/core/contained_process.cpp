#include "skydrop/core/contained_process.h"

#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <system_error>
#include <utility>

#include "skydrop/core/error.h"

#ifndef _WIN32
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

namespace skydrop::core {

#ifdef _WIN32

bool isContainmentPossible() { return false; }
std::filesystem::path runningProgram() { return {}; }
std::string runContained(const std::filesystem::path&, const std::vector<std::string>&,
                         const ContainedLimits&, std::string_view file) {
  throw DataError(file, "", "cannot be read apart on this system");
}
void limitThisProcess(const ContainedLimits&) {}
void writeContainedResult(std::string_view) {}

#else

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kHasShadow = true;
#elif defined(__has_feature)
constexpr bool kHasShadow =
    __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer);
#else
constexpr bool kHasShadow = false;
#endif

// What the child has beside its standard streams: where the result goes, and the end of a pipe that nobody
// writes to, which the system closes when the child is gone, however it ends.
constexpr int kResultDescriptor = 3, kLifeDescriptor = 4;

// The length goes first, so that half a result is none.
constexpr std::string_view kMagic = "SKYRESLT";
constexpr std::size_t kHeadBytes = 16;

class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int descriptor) : descriptor_(descriptor) {}
  Descriptor(Descriptor&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  ~Descriptor() { close(); }

  int get() const { return descriptor_; }
  void close() {
    if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
  }

 private:
  int descriptor_ = -1;
};

// Beyond those that the child's take, so that giving it one does not close the other.
Descriptor movedUp(int descriptor) {
  constexpr int kFirst = 10;
  Descriptor low(descriptor);
  return descriptor < 0 ? Descriptor() : Descriptor(::fcntl(descriptor, F_DUPFD_CLOEXEC, kFirst));
}

class SpawnActions {
 public:
  SpawnActions() { posix_spawn_file_actions_init(&actions_); }
  ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;

  posix_spawn_file_actions_t* get() { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

std::string systemReason(int code) { return std::generic_category().message(code); }

// Waits until the child is gone; false when the time is up.
bool waitForEnd(int life, double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  for (;;) {
    const double left = std::chrono::duration<double>(end - Clock::now()).count();
    if (left <= 0) return false;
    pollfd watched{life, POLLIN, 0};
    const int ready = ::poll(&watched, 1, static_cast<int>(left * 1000) + 1);
    if (ready > 0) return true;
    if (ready < 0 && errno != EINTR) return true;  // waitpid() tells
  }
}

int endOf(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) return 0;
  }
  return status;
}

std::string secondsText(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%g s", seconds);
  return text;
}

std::string refusalOf(int status, const ContainedLimits& limits) {
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    // The kernel's killer of last resort looks the same from here.
    if (signal == SIGXCPU || signal == SIGKILL)
      return "takes more than " + std::to_string(limits.cpuSeconds) + " s of processor time, or all memory";
    return "a library that reads it failed (signal " + std::to_string(signal) + ", " + strsignal(signal) +
           ")";
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) != 0)
    return "a library that reads it failed (code " + std::to_string(WEXITSTATUS(status)) + ")";
  return "";
}

std::string resultIn(int descriptor, std::string_view file) {
  struct stat facts {};
  if (::fstat(descriptor, &facts) != 0) throw DataError(file, "", systemReason(errno));
  const auto bytes = static_cast<std::uint64_t>(facts.st_size);
  if (bytes < kHeadBytes || bytes > kMostContainedBytes)
    throw DataError(file, "", "what reads it handed over " + std::to_string(bytes) + " bytes");
  std::string text(bytes, '\0');
  for (std::size_t at = 0; at < text.size();) {
    const ssize_t got = ::pread(descriptor, text.data() + at, text.size() - at, static_cast<off_t>(at));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) throw DataError(file, "", "what reads it handed over less than it said");
    at += static_cast<std::size_t>(got);
  }
  std::uint64_t length = 0;
  std::memcpy(&length, text.data() + kMagic.size(), sizeof length);
  if (!text.starts_with(kMagic) || length != text.size() - kHeadBytes)
    throw DataError(file, "", "what reads it handed over half a result");
  text.erase(0, kHeadBytes);
  return text;
}

void writeAll(const char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t written = ::write(kResultDescriptor, data, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) throw DataError("the result", "", systemReason(errno));
    data += written;
    size -= static_cast<std::size_t>(written);
  }
}

}  // namespace

bool isContainmentPossible() { return true; }

std::filesystem::path runningProgram() {
  // The link itself and not what it says: that is "FILE (deleted)" after an update.
  constexpr const char* kOwn = "/proc/self/exe";
  return ::access(kOwn, X_OK) == 0 ? kOwn : "";
}

std::string runContained(const std::filesystem::path& program, const std::vector<std::string>& words,
                         const ContainedLimits& limits, std::string_view file) {
  const auto cannotStart = [&](int code) {
    return DataError(file, "", "the program that reads it cannot be started: " + systemReason(code));
  };
  Descriptor result = movedUp(::memfd_create("skydrop result", MFD_CLOEXEC));
  if (result.get() < 0) throw cannotStart(errno);
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw cannotStart(errno);
  Descriptor life = movedUp(ends[0]), childLife = movedUp(ends[1]);
  if (life.get() < 0 || childLife.get() < 0) throw cannotStart(errno);
  SpawnActions actions;
  for (const auto& [descriptor, flags] : {std::pair{0, O_RDONLY}, {1, O_WRONLY}, {2, O_WRONLY}})
    posix_spawn_file_actions_addopen(actions.get(), descriptor, "/dev/null", flags, 0);
  posix_spawn_file_actions_adddup2(actions.get(), result.get(), kResultDescriptor);
  posix_spawn_file_actions_adddup2(actions.get(), childLife.get(), kLifeDescriptor);
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int code = ::posix_spawn(&child, program.c_str(), actions.get(), nullptr, arguments.data(), environ);
  childLife.close();
  if (code != 0) throw cannotStart(code);
  if (!waitForEnd(life.get(), limits.wallSeconds)) {
    ::kill(child, SIGKILL);
    endOf(child);
    throw DataError(file, "", "reading it takes more than " + secondsText(limits.wallSeconds));
  }
  const std::string refusal = refusalOf(endOf(child), limits);
  if (!refusal.empty()) throw DataError(file, "", refusal);
  return resultIn(result.get(), file);
}

void limitThisProcess(const ContainedLimits& limits) {
  const auto limit = [](auto what, rlim_t most) {
    const rlimit both{most, most};
    ::setrlimit(what, &both);  // a lower one of the parent's stays
  };
  const auto seconds = static_cast<rlim_t>(limits.cpuSeconds);
  limit(RLIMIT_CPU, seconds);
  limit(RLIMIT_CORE, 0);
  if (!kHasShadow) limit(RLIMIT_AS, limits.memoryBytes);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
}

void writeContainedResult(std::string_view result) {
  char head[kHeadBytes];
  const std::uint64_t length = result.size();
  std::memcpy(head, kMagic.data(), kMagic.size());
  std::memcpy(head + kMagic.size(), &length, sizeof length);
  writeAll(head, sizeof head);
  writeAll(result.data(), result.size());
}

#endif

}  // namespace skydrop::core
