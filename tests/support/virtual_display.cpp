#include "support/virtual_display.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <stdexcept>

#include "support/process.h"

namespace skydrop::test {
namespace {

constexpr int kStartMilliseconds = 20000;

// The line that the server writes once it takes clients.
std::string readLine(int descriptor) {
  std::string line;
  for (;;) {
    pollfd stream{descriptor, POLLIN, 0};
    char c = 0;
    if (poll(&stream, 1, kStartMilliseconds) <= 0 || read(descriptor, &c, 1) != 1) return "";
    if (c == '\n') return line;
    line += c;
  }
}

}  // namespace

std::string VirtualDisplay::missing() {
  for (const char* program : {"Xvfb", "xdotool"}) {
    if (!findProgram(program)) return std::string(program) + " is not installed";
  }
  return "";
}

VirtualDisplay::VirtualDisplay(int width, int height, const std::string& logFile) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  const std::string screen = std::to_string(width) + "x" + std::to_string(height) + "x24";
  server_ = std::make_unique<BackgroundProcess>(
      std::vector<std::string>{findProgram("Xvfb").value(), "-displayfd", std::to_string(ends[1]), "-screen",
                               "0", screen, "-nolisten", "tcp"},
      std::vector<std::string>{}, logFile, std::vector<int>{ends[1]});
  close(ends[1]);
  const std::string number = readLine(ends[0]);
  close(ends[0]);
  if (number.empty()) throw std::runtime_error("Xvfb did not start: see " + logFile);
  name_ = ":" + number;
}

std::string VirtualDisplay::xdotool(std::vector<std::string> words) const {
  words.insert(words.begin(), findProgram("xdotool").value());
  ProcessResult result = runProcess(words, {"DISPLAY=" + name_}, 20);
  if (result.exitCode != 0) throw std::runtime_error("xdotool " + words.at(1) + ": " + result.err);
  while (result.out.ends_with('\n')) result.out.pop_back();
  return result.out;
}

}  // namespace skydrop::test
