// The clouds' noise for all tests: made once and kept in the build tree, never in the user's home. ctest
// makes it before the suites that start the program (tests/CMakeLists.txt); a binary that is run by hand
// makes it when it needs it.
#pragma once

#include <filesystem>
#include <memory>

#include "skydrop/clouds/cloud_field.h"
#include "skydrop/clouds/noise_textures.h"

namespace skydrop::test {

// What stands for $XDG_CACHE_HOME wherever a test starts the program: $SKYDROP_TEST_CACHE, so that builds
// with sanitizers need not make the noise again, or a folder of the build tree.
std::filesystem::path sharedCacheHome();

// A texture in it, of the seed that the game uses; made if it is not there. Throws core::DataError.
core::TextureData sharedTexture(clouds::NoiseTexture texture);

// All three. Throws core::DataError.
std::shared_ptr<const clouds::PackedCloudNoise> sharedNoise();

// Copies the textures' files into a cache of the test's own.
void copySharedNoise(const std::filesystem::path& cacheFolder);

}  // namespace skydrop::test
