#include "support/virtual_display.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
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
  // Without -noreset the server forgets the layout of its keyboard when the program that set it ends.
  const std::string screen = std::to_string(width) + "x" + std::to_string(height) + "x24";
  server_ = std::make_unique<BackgroundProcess>(
      std::vector<std::string>{findProgram("Xvfb").value(), "-displayfd", std::to_string(ends[1]), "-screen",
                               "0", screen, "-nolisten", "tcp", "-noreset", "-fbdir",
                               frameBuffer_.path().string()},
      std::vector<std::string>{}, logFile, std::vector<int>{ends[1]});
  close(ends[1]);
  const std::string number = readLine(ends[0]);
  close(ends[0]);
  if (number.empty()) throw std::runtime_error("Xvfb did not start: see " + logFile);
  name_ = ":" + number;
}

void VirtualDisplay::setKeyboard(const std::string& layout) const {
  const auto program = findProgram("setxkbmap");  // comes with what the server itself needs for keyboards
  if (!program) throw std::runtime_error("setxkbmap is not installed");
  const ProcessResult result = runProcess({*program, layout}, {"DISPLAY=" + name_}, 20);
  if (result.exitCode != 0) throw std::runtime_error("setxkbmap " + layout + ": " + result.err);
}

// An XWD file (X11/XWDFile.h): a header of 32-bit numbers, most significant byte first, a colour map of
// 12-byte entries, then rows of pixels, here of 32 bits as 0x00RRGGBB.
core::Image VirtualDisplay::picture() const {
  std::ifstream file(frameBuffer_.path() / "Xvfb_screen0", std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(file)), {});
  const auto byteAt = [&](std::size_t at) { return static_cast<std::uint8_t>(bytes.at(at)); };
  const auto number = [&](std::size_t index) {
    std::size_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | byteAt(4 * index + i);
    return value;
  };
  const std::size_t width = number(4), height = number(5), bitsPerPixel = number(11), rowBytes = number(12);
  const bool leastSignificantFirst = number(7) == 0;
  if (bitsPerPixel != 32 || !leastSignificantFirst) throw std::runtime_error("the screen has another format");
  const std::size_t pixels = number(0) + 12 * number(19);
  core::Image image(static_cast<int>(width), static_cast<int>(height));
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t from = pixels + y * rowBytes + 4 * x, to = 4 * (y * width + x);
      for (std::size_t i = 0; i < 3; ++i) image.rgba[to + i] = byteAt(from + 2 - i);
      image.rgba[to + 3] = 255;
    }
  }
  return image;
}

core::Image VirtualDisplay::picture(const std::string& window) const {
  // WINDOW=7 X=0 Y=0 WIDTH=640 HEIGHT=360 SCREEN=0, a line each.
  std::istringstream lines(xdotool({"getwindowgeometry", "--shell", window}));
  int left = 0, top = 0, width = 0, height = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t equals = line.find('=');
    const std::string name = line.substr(0, equals);
    const int value = equals == std::string::npos ? 0 : std::stoi(line.substr(equals + 1));
    if (name == "X") left = value;
    if (name == "Y") top = value;
    if (name == "WIDTH") width = value;
    if (name == "HEIGHT") height = value;
  }
  const core::Image screen = picture();
  const int right = std::min(left + width, screen.width), bottom = std::min(top + height, screen.height);
  left = std::max(left, 0);
  top = std::max(top, 0);
  core::Image part(std::max(right - left, 1), std::max(bottom - top, 1));
  for (int y = 0; y < bottom - top; ++y) {
    const auto from = screen.rgba.begin() + std::ptrdiff_t{4} * ((top + y) * screen.width + left);
    std::copy(from, from + std::ptrdiff_t{4} * (right - left),
              part.rgba.begin() + std::ptrdiff_t{4} * y * part.width);
  }
  return part;
}

std::string VirtualDisplay::xdotool(std::vector<std::string> words) const {
  words.insert(words.begin(), findProgram("xdotool").value());
  ProcessResult result = runProcess(words, {"DISPLAY=" + name_}, 20);
  if (result.exitCode != 0) throw std::runtime_error("xdotool " + words.at(1) + ": " + result.err);
  while (result.out.ends_with('\n')) result.out.pop_back();
  return result.out;
}

}  // namespace skydrop::test
