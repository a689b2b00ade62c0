// An X server of the test's own, without a screen, and a hand on its keyboard and mouse.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "skydrop/core/image.h"
#include "support/background_process.h"
#include "support/temporary_folder.h"

namespace skydrop::test {

class VirtualDisplay {
 public:
  // Why there can be none on this machine (Xvfb or xdotool is missing); empty: there can.
  static std::string missing();

  // On a display number that is free. Throws std::runtime_error if the server does not start.
  VirtualDisplay(int width, int height, const std::string& logFile);

  const std::string& name() const { return name_; }  // ":99"

  // The layout of its keyboard, as setxkbmap names it: "de". Throws std::runtime_error.
  void setKeyboard(const std::string& layout) const;
  // The server ends, whoever still uses it.
  void end() { server_.reset(); }

  // What its screen shows now, as somebody before it would see it; the mouse pointer is not in it.
  core::Image picture() const;
  // The part of it where a window is, as far as it lies on the screen. `window`: xdotool's number.
  core::Image picture(const std::string& window) const;

  // Runs xdotool with these words; what it printed, without the end of the line. Throws std::runtime_error if
  // it fails.
  std::string xdotool(std::vector<std::string> words) const;

 private:
  TemporaryFolder frameBuffer_;  // the server keeps its screen in a file there
  std::unique_ptr<BackgroundProcess> server_;
  std::string name_;
};

}  // namespace skydrop::test
