// Where a program keeps its files in a home folder (XDG Base Directory Specification, 0.8).
#pragma once

#include <filesystem>

namespace skydrop::app {

// The folder skydrop in the one that an environment variable names ("XDG_CACHE_HOME"), or, where that is not
// set or not an absolute path, in `belowHome` (".cache") of $HOME. Empty without $HOME. Makes nothing.
std::filesystem::path xdgFolder(const char* variable, const std::filesystem::path& belowHome);

}  // namespace skydrop::app
