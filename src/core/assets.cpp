#include "skydrop/core/assets.h"

#include <cstdlib>

#include "skydrop/core/error.h"

namespace skydrop::core {
namespace {

bool isDataFolder(const std::filesystem::path& folder) {
  std::error_code ignored;
  return std::filesystem::is_directory(folder / "shaders", ignored) &&
         std::filesystem::is_directory(folder / "assets", ignored);
}

std::filesystem::path findDataFolder() {
  if (const char* wanted = std::getenv("SKYDROP_DATA_DIR"); wanted && *wanted) {
    if (!isDataFolder(wanted)) throw DataError(wanted, "SKYDROP_DATA_DIR", "has no shaders/ and assets/");
    return wanted;
  }
  std::error_code ignored;
  const std::filesystem::path executable = std::filesystem::read_symlink("/proc/self/exe", ignored);
  for (std::filesystem::path folder = executable.parent_path(); !folder.empty();
       folder = folder.parent_path()) {
    for (const std::filesystem::path& place : {folder, folder / "share/skydrop"})
      if (isDataFolder(place)) return place;
    if (folder == folder.root_path()) break;
  }
#ifdef SKYDROP_SOURCE_DATA_DIR
  if (isDataFolder(SKYDROP_SOURCE_DATA_DIR)) return SKYDROP_SOURCE_DATA_DIR;
#endif
  throw DataError(executable.string(), "data folder",
                  "no shaders/ and assets/ beside the program or above it; set SKYDROP_DATA_DIR");
}

}  // namespace

const std::filesystem::path& dataFolder() {
  static const std::filesystem::path folder = findDataFolder();
  return folder;
}

std::filesystem::path assetPath(std::string_view relative) { return dataFolder() / "assets" / relative; }
std::filesystem::path shaderPath(std::string_view relative) { return dataFolder() / "shaders" / relative; }

}  // namespace skydrop::core
