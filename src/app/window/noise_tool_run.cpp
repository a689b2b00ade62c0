#include "app/window/noise_tool_run.h"

#include <chrono>
#include <optional>
#include <thread>
#include <utility>

#include "app/console/message.h"
#include "app/console/standard_output.h"
#include "app/input/event_feed.h"
#include "app/input/imgui_input.h"
#include "app/input/input_code.h"
#include "app/session/open_context.h"
#include "app/window/game_window.h"
#include "app/window/noise_sky.h"
#include "app/window/noise_tool.h"
#include "app/window/window_clipboard.h"
#include "app/window/window_game.h"
#include "skydrop/core/error.h"

namespace skydrop::app {
namespace {

using render::gl::WindowEvent;

constexpr Size kUsualSize{1280, 720};
constexpr double kFramesASecond = 60;

// What is to be seen in the sky.
struct SkyRequest {
  noise::NoiseRecipe recipe;
  bool isVolume = false;
};

void prepare(NoiseTool& tool, const NoiseRequest& request) {
  takeRecipe(tool.settings(), request.texture->recipe);
  tool.settings().kind = request.texture->size.isVolume() ? NoiseKind::volume : NoiseKind::plane;
  // What cannot be read is told in the tool and here.
  if (!request.files.empty()) tool.open(request.files.front().string());
}

bool closesTool(const WindowEvent& event) {
  return event.kind == WindowEvent::Kind::key && event.code == key::kEscape && event.pressed &&
         !ImGuiInput::wantsText();
}

// Until it is closed, or what it shows is wanted in the sky. `kept`: its settings, from the last time and for
// the next; nullopt at first.
std::optional<SkyRequest> useTool(const CommandLine& line, std::optional<NoiseToolSettings>& kept) {
  GameWindow window(line);
  for (const std::string& warning : window.show(kUsualSize, std::nullopt)) warn(warning);
  ViewSettings pace;
  pace.frameCapHz = kFramesASecond;
  window.apply(pace);
  NoiseTool tool(window.context(), window.size(), window.interfaceScale());
  if (kept)
    tool.settings() = *kept;
  else
    prepare(tool, line.noise);
  std::optional<SkyRequest> wanted;
  tool.useInSky = [&](const noise::NoiseRecipe& recipe, bool isVolume) { wanted = {recipe, isVolume}; };
  WindowClipboard clipboard(window.context());
  ImGuiInput input(&clipboard);
  EventFeed feed(input);
  const auto begun = [&feed] { feed.frameBuilt(); };
  auto lastFrame = std::chrono::steady_clock::now();
  while (!window.context().shouldClose() && !wanted) {
    for (const WindowEvent& event : window.pollEvents()) feed.add(event, window.context().pixelsPerUnit());
    feed.deliver({[&](const WindowEvent& event) {
                    if (closesTool(event)) window.context().setShouldClose(true);
                    return false;
                  },
                  [] { return true; },
                  [&] { tool.buildUnseen(window.size(), window.interfaceScale(), begun); }});
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - std::exchange(lastFrame, now)).count();
    if (window.isHidden()) continue;  // pollEvents() waits meanwhile
    const Size size = window.size();
    tool.draw(size, seconds, window.interfaceScale(), begun);
    tool.renderer().present(size.width, size.height);
    window.swap();
    window.waitForNextFrame();
  }
  kept = tool.settings();
  return wanted;
}

}  // namespace

void runNoiseTool(const CommandLine& line) {
  std::optional<NoiseToolSettings> kept;
  while (const std::optional<SkyRequest> wanted = useTool(line, kept)) {
    WindowGame(flightUnder(wanted->recipe, wanted->isVolume, line)).run();
    if (WindowGame::wasAskedToEnd()) return;
  }
}

void drawNoiseTool(const CommandLine& line) {
  core::OutputFile file = openOutput(line.noise.file).value();
  const Size size = line.size.value_or(kUsualSize);
  const auto context = openContext(line.backend, size);
  NoiseTool tool(*context, size);
  tool.showsTimes = false;
  prepare(tool, line.noise);
  // The frame that shows the finished texture, and one before it in which Dear ImGui's windows find their
  // size.
  int finished = 0;
  while (finished < 2) {
    tool.draw(size, 0);
    if (tool.isSettled())
      ++finished;
    else
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  file.write(core::encodePng(tool.renderer().readBack()));
}

}  // namespace skydrop::app
