#include "app/settings/xdg_folder.h"

#include <cstdlib>

namespace skydrop::app {

std::filesystem::path xdgFolder(const char* variable, const std::filesystem::path& belowHome) {
  if (const char* named = std::getenv(variable); named && *named == '/') {
    return std::filesystem::path(named) / "skydrop";
  }
  if (const char* home = std::getenv("HOME"); home && *home) {
    return std::filesystem::path(home) / belowHome / "skydrop";
  }
  return {};
}

}  // namespace skydrop::app
