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

// Regular files only: a folder, pipe, socket or device is refused at once, and never waited for. Refuses what
// is larger than `maxBytes` (256 MiB, text 64 MiB, unless told): nothing of ours is larger.
std::vector<std::byte> readFile(const std::filesystem::path& path,
                                std::size_t maxBytes = std::size_t{256} << 20);
std::string readTextFile(const std::filesystem::path& path, std::size_t maxBytes = std::size_t{64} << 20);

// The first bytes of a regular file, fewer where it is shorter: what tells forms apart.
std::string readFileStart(const std::filesystem::path& path, std::size_t bytes);

// For files that the command line names: "-" is standard input, read to its end, anything else as above.
bool isStandardInput(const std::filesystem::path& path);
std::vector<std::byte> readInput(const std::filesystem::path& path,
                                 std::size_t maxBytes = std::size_t{256} << 20);
std::string readTextInput(const std::filesystem::path& path, std::size_t maxBytes = std::size_t{64} << 20);
// As messages name it: the path, or "standard input".
std::string inputName(const std::filesystem::path& path);

// Writes the whole content to what `path` names (output_file.h): after a failure the old file stands as it
// was and no temporary is left.
void writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> bytes);
void writeFileAtomically(const std::filesystem::path& path, std::string_view text);

// Makes a folder and those that it lies in, as far as they are missing.
void makeFolder(const std::filesystem::path& path);

}  // namespace skydrop::core
