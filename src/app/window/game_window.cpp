#include "app/window/game_window.h"

#include <utility>

#include "app/measure/system_info.h"
#include "app/window/screen_fit.h"

namespace skydrop::app {
namespace {

using render::gl::WindowContext;
using render::gl::WindowEvent;
using render::gl::WindowRect;

constexpr double kHiddenPeriod = 0.1;  // s between looks at what happened while nobody sees the window
constexpr int kEnter = 257, kKeypadEnter = 335, kAlt = 4;  // GLFW's

bool isAltEnter(const WindowEvent& event) {
  return event.kind == WindowEvent::Kind::key && (event.code == kEnter || event.code == kKeypadEnter) &&
         (event.modifiers & kAlt) != 0;
}

std::string sizeText(const WindowRect& rect) {
  return std::to_string(rect.width) + "x" + std::to_string(rect.height);
}

}  // namespace

GameWindow::GameWindow(const CommandLine& line)
    : placedByHand_(line.size || line.fullscreen),
      fullScreenWanted_(line.fullscreen),
      sizeWanted_(line.size),
      context_(render::gl::WindowSettings{.visible = false}) {}

std::vector<std::string> GameWindow::show(Size usual, const std::optional<std::filesystem::path>& folder) {
  usual_.width = usual.width;
  usual_.height = usual.height;
  remembered_ = usual_;
  std::vector<std::string> warnings;
  if (folder) {
    memoryFile_ = KeptFile(windowMemoryFile(*folder));
    if (auto warning = loadWindowMemory(remembered_, memoryFile_)) warnings.push_back(std::move(*warning));
  }
  saved_ = remembered_;
  const WindowMemory& place = remembered_;
  const bool placed = !placedByHand_ && place.moved;
  WindowRect wanted = context_.rect();
  wanted.width = sizeWanted_ ? sizeWanted_->width : static_cast<int>(place.width);
  wanted.height = sizeWanted_ ? sizeWanted_->height : static_cast<int>(place.height);
  if (placed) {
    wanted.left = static_cast<int>(place.left);
    wanted.top = static_cast<int>(place.top);
  }
  const WindowRect held = heldToScreen(wanted, context_.frame(), context_.screens());
  if (sizeWanted_ && (held.width != wanted.width || held.height != wanted.height)) {
    warnings.push_back("--size " + sizeText(wanted) + ": the screen has room for " + sizeText(held) +
                       "; `skydrop render` draws any size");
  }
  context_.setSize(held.width, held.height);
  if (placed) context_.setPosition(held.left, held.top);
  context_.show();
  context_.pollEvents();
  opened_ = context_.rect();
  if (fullScreenWanted_ || (!placedByHand_ && place.fullScreen)) context_.setFullScreen(true);
  return warnings;
}

std::optional<std::string> GameWindow::remember() {
  WindowMemory now = remembered_;
  if (!placedByHand_) {
    const WindowRect rect = context_.rect();
    // What the player did not change may have been held to a smaller screen than it was remembered for.
    if (rect.width != opened_.width || rect.height != opened_.height) {
      now.width = rect.width;
      now.height = rect.height;
    }
    now.fullScreen = context_.isFullScreen();
    if (rect.left != opened_.left || rect.top != opened_.top) {
      now.moved = true;
      now.left = rect.left;
      now.top = rect.top;
    }
  }
  std::optional<std::string> warning = saveWindowMemory(now, saved_, usual_, memoryFile_);
  saved_ = now;
  return warning;
}

bool GameWindow::takeSoftwareNews() { return !std::exchange(remembered_.knowsSoftware, true); }

void GameWindow::apply(const ViewSettings& settings) {
  interfaceScale_ = settings.interfaceScale;
  frameCapHz_ = settings.frameCapHz;
  if (vsync_ != settings.vsync) context_.setVsync(settings.vsync);
  vsync_ = settings.vsync;
}

std::vector<WindowEvent> GameWindow::pollEvents() {
  if (isHidden()) context_.waitEvents(kHiddenPeriod);
  std::vector<WindowEvent> events = context_.pollEvents();
  for (const WindowEvent& event : events) {
    if (isAltEnter(event) && event.pressed && !event.repeated) toggleFullScreen();
  }
  std::erase_if(events, isAltEnter);
  return events;
}

void GameWindow::swap() {
  context_.swap();
  if (firstPictureMs_ == 0) firstPictureMs_ = 1000 * secondsSinceStart();
}

void GameWindow::waitForNextFrame() {
  pacer_.wait(frameCapHz_);
  const auto now = std::chrono::steady_clock::now();
  if (lastFrame_) intervals_.add(std::chrono::duration<double, std::milli>(now - *lastFrame_).count());
  lastFrame_ = now;
}

void GameWindow::writeTo(core::FrameStatistics& statistics) const {
  core::WindowStatistics& window = statistics.window;
  window.width = size().width;
  window.height = size().height;
  window.fullScreen = context_.isFullScreen();
  window.hidden = isHidden();
  window.firstPictureMs = firstPictureMs_;
  window.medianIntervalMs = intervals_.quantile(0.5);
  window.p99IntervalMs = intervals_.quantile(0.99);
}

}  // namespace skydrop::app
