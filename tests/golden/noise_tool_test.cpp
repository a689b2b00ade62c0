// The noise tool's picture, as the program draws it without a window, against the one that was looked at.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "skydrop/core/image.h"
#include "support/image_compare.h"
#include "support/paths.h"
#include "support/process.h"
#include "support/temporary_folder.h"

namespace skydrop::test {
namespace {

// As of the game's frames (golden_test.cpp).
constexpr ImageLimits kSoftwareRounding{48, 0.02};

void expectGolden(const std::string& name, const std::vector<std::string>& words) {
  const char* backend = std::getenv("SKYDROP_TEST_BACKEND");
  const TemporaryFolder folder;
  const std::filesystem::path picture = folder.path() / (name + ".png");
  std::vector<std::string> all = {"noise", "--tool",         "--size",    "960x540",
                                  "--out", picture.string(), "--backend", backend ? backend : "egl"};
  all.insert(all.end(), words.begin(), words.end());
  const ProcessResult result = runSkydrop(all);
  if (result.exitCode == 3) GTEST_SKIP() << result.err;
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const std::filesystem::path reference =
      std::filesystem::path(sourceDir()) / "tests/golden" / (name + ".png");
  EXPECT_TRUE(matchesReference(core::readPng(picture), reference, kSoftwareRounding));
}

TEST(GoldenNoiseTool, plainTexture) { expectGolden("noiseToolTexture", {}); }
TEST(GoldenNoiseTool, volumeOfClouds) {
  expectGolden("noiseToolVolume", {"--generate", "3d", "--frequency", "3", "--cutoff", "0.5", "--seed", "4"});
}

}  // namespace
}  // namespace skydrop::test
