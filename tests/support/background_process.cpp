#include "support/background_process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <thread>

#include "support/process.h"

namespace skydrop::test {
namespace {

constexpr double kSecondsToEnd = 5;
constexpr auto kPollPeriod = std::chrono::milliseconds(10);

}  // namespace

std::optional<std::string> findProgram(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::string file = (std::filesystem::path(folder) / name).string();
    if (access(file.c_str(), X_OK) == 0) return file;
  }
  return std::nullopt;
}

BackgroundProcess::BackgroundProcess(const std::vector<std::string>& words,
                                     const std::vector<std::string>& environment, const std::string& logFile,
                                     const std::vector<int>& kept) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  pid_ = fork();
  if (pid_ != 0) return;

  prctl(PR_SET_PDEATHSIG, SIGKILL);
  signal(SIGHUP, SIG_DFL);  // whatever the test runs under may ignore it
  applyEnvironment(environment);
  const int log = open(logFile.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  dup2(open("/dev/null", O_RDONLY | O_CLOEXEC), STDIN_FILENO);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  for (const int descriptor : kept) fcntl(descriptor, F_SETFD, 0);
  execv(arguments[0], arguments.data());
  _exit(127);
}

BackgroundProcess::~BackgroundProcess() {
  if (pid_ <= 0 || !isRunning()) return;
  askToEnd();
  if (wait(kSecondsToEnd)) return;
  kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

bool BackgroundProcess::isRunning() { return !wait(0); }

void BackgroundProcess::send(int signal) {
  if (pid_ > 0 && !exitCode_) kill(pid_, signal);
}

void BackgroundProcess::askToEnd() { send(SIGTERM); }

std::optional<int> BackgroundProcess::wait(double timeoutSeconds) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::duration<double>(timeoutSeconds);
  while (!exitCode_) {
    int status = 0;
    if (pid_ <= 0 || waitpid(pid_, &status, WNOHANG) == pid_) {
      exitCode_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    } else if (std::chrono::steady_clock::now() >= deadline) {
      return std::nullopt;
    } else {
      std::this_thread::sleep_for(kPollPeriod);
    }
  }
  return exitCode_;
}

}  // namespace skydrop::test
