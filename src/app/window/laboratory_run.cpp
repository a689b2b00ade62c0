#include "app/window/laboratory_run.h"

#include <chrono>
#include <optional>
#include <utility>

#include "app/console/message.h"
#include "app/input/event_feed.h"
#include "app/input/imgui_input.h"
#include "app/input/input_code.h"
#include "app/window/game_window.h"
#include "app/window/laboratory.h"
#include "app/window/window_clipboard.h"
#include "app/window/window_game.h"

namespace skydrop::app {
namespace {

using render::gl::WindowEvent;

constexpr Size kUsualSize{1280, 720};
constexpr double kFramesASecond = 60;

bool closesIt(const WindowEvent& event) {
  return event.kind == WindowEvent::Kind::key && event.code == key::kEscape && event.pressed &&
         !ImGuiInput::wantsText();
}

}  // namespace

void runLaboratory(const CommandLine& line) {
  const lab::Page* page = line.lab.page ? &lab::pageNamed(*line.lab.page) : nullptr;
  if (page) {
    // What cannot be set is refused before a window opens.
    const std::unique_ptr<lab::Knobs> knobs = page->makeKnobs();
    for (const std::string& assignment : line.set) core::setField(knobs->table(), assignment);
  }
  GameWindow window(line);
  for (const std::string& warning : window.show(kUsualSize, std::nullopt)) warn(warning);
  ViewSettings pace;
  pace.frameCapHz = kFramesASecond;
  window.apply(pace);
  Laboratory room(window.context(), window.size(), window.interfaceScale());
  if (page) {
    room.open(*page);
    for (const std::string& assignment : line.set) core::setField(room.knobs().table(), assignment);
  }
  WindowClipboard clipboard(window.context());
  ImGuiInput input(&clipboard);
  EventFeed feed(input);
  const auto begun = [&feed] { feed.frameBuilt(); };
  auto lastFrame = std::chrono::steady_clock::now();
  while (!window.context().shouldClose() && !WindowGame::wasAskedToEnd()) {
    for (const WindowEvent& event : window.pollEvents()) feed.add(event, window.context().pixelsPerUnit());
    feed.deliver({[&](const WindowEvent& event) {
                    if (closesIt(event)) window.context().setShouldClose(true);
                    return false;
                  },
                  [] { return true; },
                  [&] { room.buildUnseen(window.size(), window.interfaceScale(), begun); }});
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - std::exchange(lastFrame, now)).count();
    if (window.isHidden()) continue;  // pollEvents() waits meanwhile
    const Size size = window.size();
    room.draw(size, seconds, window.interfaceScale(), begun);
    room.renderer().present(size.width, size.height);
    window.swap();
    window.waitForNextFrame();
  }
}

}  // namespace skydrop::app
