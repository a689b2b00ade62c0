#include "support/process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>

#include "support/paths.h"
#include "support/shared_noise.h"

namespace skydrop::test {

void applyEnvironment(const std::vector<std::string>& environment) {
  for (const std::string& entry : environment) {
    const std::size_t equals = entry.find('=');
    if (equals == std::string::npos)
      unsetenv(entry.c_str());
    else
      setenv(entry.substr(0, equals).c_str(), entry.substr(equals + 1).c_str(), 1);
  }
}

namespace {

[[noreturn]] void runChild(const std::vector<std::string>& words, const std::vector<std::string>& environment,
                           int out, int err) {
  applyEnvironment(environment);
  dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  execv(arguments[0], arguments.data());
  _exit(127);
}

// Appends what is there; false at the end of the stream.
bool drain(int descriptor, std::string& text) {
  char piece[4096];
  const ssize_t count = read(descriptor, piece, sizeof piece);
  if (count > 0) text.append(piece, static_cast<std::size_t>(count));
  return count > 0;
}

}  // namespace

ProcessResult runProcess(const std::vector<std::string>& words, const std::vector<std::string>& environment,
                         double timeoutSeconds) {
  int out[2], err[2];
  if (pipe2(out, O_CLOEXEC) != 0 || pipe2(err, O_CLOEXEC) != 0) return {};
  const pid_t child = fork();
  if (child == 0) runChild(words, environment, out[1], err[1]);
  close(out[1]);
  close(err[1]);

  ProcessResult result;
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::duration<double>(timeoutSeconds);
  bool outOpen = true, errOpen = true, timedOut = false;
  while (outOpen || errOpen) {
    pollfd streams[2] = {{outOpen ? out[0] : -1, POLLIN, 0}, {errOpen ? err[0] : -1, POLLIN, 0}};
    poll(streams, 2, 100);
    if (streams[0].revents != 0) outOpen = drain(out[0], result.out);
    if (streams[1].revents != 0) errOpen = drain(err[0], result.err);
    if (!timedOut && std::chrono::steady_clock::now() > deadline) {
      timedOut = true;
      kill(child, SIGKILL);
    }
  }
  close(out[0]);
  close(err[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFEXITED(status)) result.exitCode = WEXITSTATUS(status);
  return result;
}

ProcessResult runSkydrop(std::vector<std::string> words, double timeoutSeconds) {
  words.insert(words.begin(), test::programFile());
  return runProcess(words, {"DISPLAY", "WAYLAND_DISPLAY", "XDG_CACHE_HOME=" + sharedCacheHome().string()},
                    timeoutSeconds);
}

}  // namespace skydrop::test
