#include "app/window_memory.h"

#include <nlohmann/json.hpp>

#include "app/user_settings.h"
#include "skydrop/core/settings_file.h"

namespace skydrop::app {

void describe(core::SettingsVisitor& visitor, WindowMemory& memory) {
  visitor.integer("width", memory.width, {"pixel", 1, 16384, "Width of the window."});
  visitor.integer("height", memory.height, {"pixel", 1, 16384, "Height of the window."});
  visitor.flag("moved", memory.moved, {"Whether the window stands where left and top say."});
  visitor.integer("left", memory.left, {"pixel", -100000, 100000, "Left edge of the window on the desktop."});
  visitor.integer("top", memory.top, {"pixel", -100000, 100000, "Upper edge of the window on the desktop."});
  visitor.flag("fullScreen", memory.fullScreen, {"Whether the window fills the screen."});
  visitor.flag("knowsSoftware", memory.knowsSoftware,
               {"Whether the player was told that there is no graphics card."});
}

std::filesystem::path windowMemoryFile(const std::filesystem::path& folder) { return folder / "window.json"; }

std::optional<std::string> loadWindowMemory(WindowMemory& memory, const std::filesystem::path& folder) {
  const std::filesystem::path file = windowMemoryFile(folder);
  return loadOrSetAside(file, [&] {
    core::applyJson(core::SettingsTable(memory), core::readSettingsFile(file)["settings"], file.string());
  });
}

void saveWindowMemory(WindowMemory memory, WindowMemory usual, const std::filesystem::path& folder) {
  core::writeSettingsFile(
      windowMemoryFile(folder),
      {{"settings", changedJson(core::SettingsTable(memory), core::SettingsTable(usual))}});
}

}  // namespace skydrop::app
