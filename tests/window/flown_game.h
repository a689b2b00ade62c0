// The real program in a real window on a display of the test's own: keys go in, statistics and screenshots
// come out. It watches the statistics file, which the program rewrites twice a second, and waits for what
// must happen; nothing is timed by sleeping.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "skydrop/core/image.h"
#include "support/temporary_folder.h"
#include "support/virtual_display.h"

namespace skydrop::test {

// In a test that needs a window.
#define SKIP_WITHOUT_DISPLAY() \
  if (!VirtualDisplay::missing().empty()) GTEST_SKIP() << VirtualDisplay::missing()

class FlownGame {
 public:
  static constexpr int kDisplayWidth = 800, kDisplayHeight = 600;
  static constexpr int kWidth = 640, kHeight = 360;

  struct Launch {
    std::vector<std::string> words = {};    // the scene `terrain` unless they name another, or a replay
    std::string userSettings = {};          // the player's file, none if empty
    bool sized = true;                      // kWidth x kHeight by the command line
    std::filesystem::path userFolder = {};  // empty: one of its own
    std::string keyboard = {};  // layout as setxkbmap names it: "de"; empty: the server's, American
    std::vector<std::string> environment = {};  // besides the tests' own: "NAME=value"
  };

  // Starts it and waits until it has drawn and has the keyboard. Throws std::runtime_error.
  explicit FlownGame(std::vector<std::string> words = {}, const std::string& userSettings = {})
      : FlownGame(Launch{std::move(words), userSettings}) {}
  explicit FlownGame(Launch launch);

  using Condition = std::function<bool(const nlohmann::json&)>;
  // Waits until the statistics fulfil it; false after a minute.
  bool waitFor(const Condition& condition);
  // The statistics as they stand.
  nlohmann::json statistics() const;
  nlohmann::json window() const { return statistics().at("window"); }

  void press(const std::string& key) const;  // down and up at once; names as xdotool's: "w", "F1", "space"
  void type(const std::string& text) const;  // letter by letter
  void hold(const std::string& key) const;
  void release(const std::string& key) const;
  // In window coordinates.
  void moveMouse(float x, float y) const;
  void clickMouse(const std::string& action) const;  // "click", "mousedown", "mouseup"
  void resize(int width, int height) const;
  void focus() const;
  void loseFocus() const;

  // Presses F12 and reads the picture.
  core::Image screenshot();
  // What the display shows at the window's place: what arrives there, whatever the game believes it drew.
  core::Image shown() const;
  // Waits until that fulfils the condition; false after a minute.
  bool waitForPicture(const std::function<bool(const core::Image&)>& condition);

  BackgroundProcess& process() { return *process_; }
  std::filesystem::path userFolder() const { return userFolder_; }
  std::filesystem::path statisticsFile() const { return folder_.path() / "stats.json"; }
  // Takes the window off the screen, as if minimised, and back.
  void hide() const { display_->xdotool({"windowunmap", window_}); }
  void unhide() const { display_->xdotool({"windowmap", window_}); }
  // The display goes away under the running game.
  void endDisplay() { display_->end(); }
  std::string log() const;

 private:
  TemporaryFolder folder_;
  std::filesystem::path userFolder_;
  std::unique_ptr<VirtualDisplay> display_;
  std::unique_ptr<BackgroundProcess> process_;  // ends before its display
  std::string window_;                          // X's number for it
};

}  // namespace skydrop::test
