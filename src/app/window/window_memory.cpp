#include "app/window/window_memory.h"

#include <nlohmann/json.hpp>

#include "skydrop/core/settings_table.h"

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
  visitor.flag("knowsBriefing", memory.knowsBriefing, {"Whether the player has read the briefing."});
}

std::filesystem::path windowMemoryFile(const std::filesystem::path& folder) { return folder / "window.json"; }

std::optional<std::string> loadWindowMemory(WindowMemory& memory, KeptFile& file) {
  if (auto broken = file.load()) return broken;
  return file.complaintLine(
      core::applyJsonWhereItFits(core::SettingsTable(memory), file.content()["settings"]));
}

std::optional<std::string> saveWindowMemory(WindowMemory memory, WindowMemory before, WindowMemory usual,
                                            KeptFile& file) {
  const core::SettingsTable table(memory), beforeTable(before), usualTable(usual);
  const nlohmann::json values = core::toJson(table);
  return file.save([&](nlohmann::json& content) {
    for (std::size_t i = 0; i < table.fields().size(); ++i) {
      const core::Field& field = table.fields()[i];
      if (field.get() == beforeTable.fields()[i].get()) continue;
      if (field.get() == usualTable.fields()[i].get()) {
        eraseAt(content["settings"], field.path);
      } else {
        setAt(content["settings"], field.path, values[field.path]);
      }
    }
  });
}

}  // namespace skydrop::app
