// What is remembered of the window from one flight to the next: window.json in the player's folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "app/settings/kept_file.h"
#include "skydrop/core/settings.h"

namespace skydrop::app {

// Window coordinates of its content, as it stands when it does not fill the screen.
struct WindowMemory {
  std::int64_t width = 1280, height = 720;
  bool moved = false;  // the player put it somewhere: left and top count
  std::int64_t left = 0, top = 0;
  bool fullScreen = false;
  bool knowsSoftware = false;  // the player was told that this machine draws in software
  bool knowsBriefing = false;  // the player was told what there is to do
};

void describe(core::SettingsVisitor& visitor, WindowMemory& memory);

std::filesystem::path windowMemoryFile(const std::filesystem::path& folder);

// Applies the file to `memory` where it fits; what is wrong with it comes back as one line (kept_file.h).
std::optional<std::string> loadWindowMemory(WindowMemory& memory, KeptFile& file);

// Writes what differs from `before`, the state when the file was read or written last; what is `usual` is
// taken out of the file. The line to warn of comes back. Throws core::DataError.
std::optional<std::string> saveWindowMemory(WindowMemory memory, WindowMemory before, WindowMemory usual,
                                            KeptFile& file);

}  // namespace skydrop::app
