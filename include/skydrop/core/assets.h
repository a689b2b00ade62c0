// Where the program's own data lies: assets/ and shaders/ under one data folder.
#pragma once

#include <filesystem>
#include <string_view>

namespace skydrop::core {

// The first of these that holds shaders/ and assets/: $SKYDROP_DATA_DIR; the folder of the executable and
// those above it, each with its share/skydrop; the source tree it was built from, unless it was built for
// installing. Found once. Throws DataError when there is none, or when $SKYDROP_DATA_DIR is set and is not
// one.
const std::filesystem::path& dataFolder();

std::filesystem::path assetPath(std::string_view relative);   // "models/airplane.glb"
std::filesystem::path shaderPath(std::string_view relative);  // "terrain/land.frag"

}  // namespace skydrop::core
