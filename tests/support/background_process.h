// A program that runs beside the test: started, watched and ended by its own process id alone.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace skydrop::test {

// The file of that name in $PATH, as a shell would find it.
std::optional<std::string> findProgram(const std::string& name);

class BackgroundProcess {
 public:
  // words[0] is the program's file. `environment` is added to the caller's; "NAME" alone takes the variable
  // away. Output and errors go to `logFile`. `kept` descriptors stay open in it. It dies with the test.
  BackgroundProcess(const std::vector<std::string>& words, const std::vector<std::string>& environment,
                    const std::string& logFile, const std::vector<int>& kept = {});
  // Asks it to end and, where it does not within five seconds, kills it.
  ~BackgroundProcess();
  BackgroundProcess(const BackgroundProcess&) = delete;
  BackgroundProcess& operator=(const BackgroundProcess&) = delete;

  bool isRunning();
  void send(int signal);
  // SIGTERM.
  void askToEnd();
  // The exit code, 128 + n after signal n; nullopt if it still runs after that time.
  std::optional<int> wait(double timeoutSeconds);

 private:
  pid_t pid_ = -1;
  std::optional<int> exitCode_;
};

}  // namespace skydrop::test
