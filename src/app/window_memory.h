// What is remembered of the window from one flight to the next: window.json in the player's folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "app/command_line.h"
#include "skydrop/core/settings.h"

namespace skydrop::app {

// Window coordinates of its content, as it stands when it does not fill the screen.
struct WindowMemory {
  std::int64_t width = 1280, height = 720;
  bool moved = false;  // the player put it somewhere: left and top count
  std::int64_t left = 0, top = 0;
  bool fullScreen = false;
  bool knowsSoftware = false;  // the player was told that this machine draws in software
};

void describe(core::SettingsVisitor& visitor, WindowMemory& memory);

std::filesystem::path windowMemoryFile(const std::filesystem::path& folder);

// Applies the file to `memory`, if there is one. Broken, it is kept aside as `.bad` and the line to say so
// comes back (user_settings.h).
std::optional<std::string> loadWindowMemory(WindowMemory& memory, const std::filesystem::path& folder);

// Writes what differs from `usual`. Throws core::DataError.
void saveWindowMemory(WindowMemory memory, WindowMemory usual, const std::filesystem::path& folder);

}  // namespace skydrop::app
