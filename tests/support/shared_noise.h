// The clouds' noise for all tests: made once and kept in the build tree, never in the user's home. ctest
// makes it before the suites that start the program (tests/CMakeLists.txt); a binary that is run by hand
// makes it when it needs it.
#pragma once

#include <filesystem>
#include <memory>

#include "skydrop/clouds/cloud_field.h"

namespace skydrop::test {

// What stands for $XDG_CACHE_HOME wherever a test starts the program.
std::filesystem::path sharedCacheHome();

// The textures in it, of the seed that the game uses. Throws core::DataError.
std::shared_ptr<const clouds::FoldedNoise> sharedNoise();

// Copies the textures' files into a cache of the test's own.
void copySharedNoise(const std::filesystem::path& cacheFolder);

}  // namespace skydrop::test
