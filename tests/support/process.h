// Runs a program and waits for it: command-line tests.
#pragma once

#include <string>
#include <vector>

namespace skydrop::test {

struct ProcessResult {
  int exitCode = -1;  // -1: it was killed, by the timeout or a signal
  std::string out, err;
};

// words[0] is the program. `environment` is added to the caller's; "NAME" alone takes the variable away.
ProcessResult runProcess(const std::vector<std::string>& words,
                         const std::vector<std::string>& environment = {}, double timeoutSeconds = 60);

// In a child before exec: "NAME=value" sets a variable, "NAME" alone takes it away.
void applyEnvironment(const std::vector<std::string>& environment);

// Runs the built skydrop, without a display, with the cache that all tests share.
ProcessResult runSkydrop(std::vector<std::string> words, double timeoutSeconds = 60);

}  // namespace skydrop::test
