// Whole files, read and written so that a full disk, a missing folder or a crash loses nothing.
// Any thread. Every failure is a DataError that names the file and the system's reason.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace skydrop::core {

// Refuses folders, and files beyond `maxBytes` (256 MiB unless told): nothing of ours is larger.
std::vector<std::byte> readFile(const std::filesystem::path& path, std::size_t maxBytes = std::size_t{256} << 20);
std::string readTextFile(const std::filesystem::path& path, std::size_t maxBytes = std::size_t{64} << 20);

// Writes the whole content to what `path` names (output_file.h): after a failure the old file stands as it was
// and no temporary is left.
void writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> bytes);
void writeFileAtomically(const std::filesystem::path& path, std::string_view text);

// Makes a folder and those that it lies in, as far as they are missing.
void makeFolder(const std::filesystem::path& path);

}  // namespace skydrop::core
