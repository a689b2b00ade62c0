// The player's window: where it opens and what of that is remembered, full screen, vsync and the pace of its
// frames. Main thread.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/measure/frame_times.h"
#include "app/settings/settings.h"
#include "app/types/command_line.h"
#include "app/window/frame_pacer.h"
#include "app/window/window_memory.h"
#include "skydrop/core/frame_statistics.h"
#include "skydrop/render/platform/window_context.h"
#include "skydrop/ui/imgui_context.h"

namespace skydrop::app {

class GameWindow {
 public:
  // Not shown yet: its size may depend on what draws it. Throws core::GraphicsUnavailable.
  explicit GameWindow(const CommandLine& line);

  render::gl::WindowContext& context() { return context_; }
  Size size() const { return {context_.width(), context_.height()}; }

  // Shows it as the command line says, else as remembered in the folder, else in the usual size; never larger
  // than its screen or beside it. What to warn of comes back.
  std::vector<std::string> show(Size usual, const std::optional<std::filesystem::path>& folder);
  // Keeps what the player changed, unless the command line said where it opens. What to warn of comes back.
  // Throws core::DataError.
  std::optional<std::string> remember();

  // True once for each player who draws in software: it is news, and remembered.
  bool takeSoftwareNews();
  // True for a player who has not read the briefing, where the window is one that is remembered.
  bool wantsBriefing() const {
    return !placedByHand_ && !memoryFile_.path().empty() && !remembered_.knowsBriefing;
  }
  void noteBriefing() { remembered_.knowsBriefing = true; }

  void apply(const ViewSettings& settings);
  ui::InterfaceScale interfaceScale() const { return {interfaceScale_, context_.contentScale()}; }
  void toggleFullScreen() { context_.setFullScreen(!context_.isFullScreen()); }

  // What happened since the last call. Alt and Enter is full screen, and is nobody else's. While nobody sees
  // the window it waits a little, so that a loop that draws nothing does not spin.
  std::vector<render::gl::WindowEvent> pollEvents();
  bool isHidden() const { return context_.isHidden(); }

  // Shows what was drawn.
  void swap();
  // Until the cap on the frame rate lets it begin.
  void waitForNextFrame();
  void writeTo(core::FrameStatistics& statistics) const;

 private:
  bool placedByHand_;  // by the command line
  bool fullScreenWanted_;
  std::optional<Size> sizeWanted_;
  render::gl::WindowContext context_;
  KeptFile memoryFile_;
  WindowMemory usual_, remembered_;
  WindowMemory saved_;  // as the file was read or written last
  render::gl::WindowRect opened_;
  double interfaceScale_ = 1;
  double frameCapHz_ = 0;
  std::optional<bool> vsync_;
  FramePacer pacer_;
  FrameTimes intervals_;
  std::optional<std::chrono::steady_clock::time_point> lastFrame_;
  double firstPictureMs_ = 0;
};

}  // namespace skydrop::app
