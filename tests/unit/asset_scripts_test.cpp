#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "skydrop/core/file.h"
#include "support/paths.h"
#include "support/process.h"
#include "support/python.h"
#include "support/temporary_folder.h"

namespace skydrop {
namespace {

const char* folderOf(const std::string& name) {
  for (const auto& [ending, folder] : {std::pair(".wav", "audio"), {".svg", "desktop"}, {".tif", "elevation"}})
    if (name.ends_with(ending)) return folder;
  return "models";
}

class AssetScripts : public ::testing::TestWithParam<const char*> {};

TEST_P(AssetScripts, makeTheirFilesAgainBitForBit) {
  // A script run into an empty folder writes the files of assets/ byte for byte.
  const std::string python = test::pythonWithNumpy();
  if (python.empty()) GTEST_SKIP() << "no python3 with numpy";
  const std::filesystem::path assets = std::filesystem::path(test::sourceDir()) / "assets";
  const test::TemporaryFolder folder;
  const test::ProcessResult result =
      test::runProcess({python, (assets / "scripts" / GetParam()).string(), folder.path().string()},
                       {"PYTHONDONTWRITEBYTECODE=1"}, 100);
  ASSERT_EQ(result.exitCode, 0) << result.err;
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    const std::string name = entry.path().filename().string();
    const std::filesystem::path kept = assets / folderOf(name) / name;
    ASSERT_TRUE(std::filesystem::exists(kept)) << name;
    EXPECT_TRUE(core::readFile(kept) == core::readFile(entry.path())) << name << " differs";
    ++files;
  }
  EXPECT_GT(files, 0);
}

INSTANTIATE_TEST_SUITE_P(, AssetScripts,
                         ::testing::Values("make_airplane.py", "make_icon.py", "make_mittelland.py",
                                           "make_package.py", "make_sounds.py"),
                         [](const auto& script) {
                           const std::string name(script.param);
                           return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace skydrop
