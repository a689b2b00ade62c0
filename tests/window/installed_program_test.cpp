// The program as it is installed, wherever its tree is moved.
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>

#include "skydrop/core/file.h"
#include "skydrop/core/image.h"
#include "support/background_process.h"
#include "support/paths.h"
#include "support/process.h"
#include "support/temporary_folder.h"

namespace skydrop::test {
namespace {

namespace fs = std::filesystem;

ProcessResult install(const fs::path& prefix) {
  return runProcess(
      {findProgram("cmake").value(), "--install", binaryDir(), "--prefix", prefix.string(), "--strip"}, {},
      120);
}

TEST(InstalledProgram, findsItsDataBesideItselfWhereverTheTreeIsMoved) {
  const TemporaryFolder folder;
  const fs::path first = folder.path() / "first", moved = folder.path() / "moved to";
  const ProcessResult installing = install(first);
  ASSERT_EQ(installing.exitCode, 0) << installing.err;
  fs::rename(first, moved);

  const std::string program = (moved / "bin/skydrop").string();
  const auto run = [&](std::vector<std::string> words) {
    words.insert(words.begin(), program);
    return runProcess(words,
                      {"DISPLAY", "WAYLAND_DISPLAY", "LIBGL_ALWAYS_SOFTWARE=1", "SKYDROP_DATA_DIR",
                       "HOME=" + (folder.path() / "home").string(), "XDG_CACHE_HOME", "XDG_CONFIG_HOME"});
  };
  const ProcessResult info = run({"info"});
  ASSERT_EQ(info.exitCode, 0) << info.err;
  EXPECT_NE(info.out.find("data " + (moved / "share/skydrop").string() + "\n"), std::string::npos)
      << info.out;
  const std::string picture = (folder.path() / "a.png").string();
  const ProcessResult render = run({"render", "--scene", "duskPlanes", "--size", "64x36", "--out", picture});
  ASSERT_EQ(render.exitCode, 0) << render.err;
  EXPECT_EQ(core::readPng(picture).width, 64);
  // What is installed is what is used: a scene that is gone is unknown, though the sources have it.
  fs::remove(moved / "share/skydrop/assets/scenes/duskPlanes.json");
  EXPECT_EQ(run({"render", "--scene", "duskPlanes", "--size", "64x36", "--out", picture}).exitCode, 1);
}

TEST(InstalledProgram, hasWhatADesktopLooksFor) {
  const TemporaryFolder folder;
  const ProcessResult installing = install(folder.path());
  ASSERT_EQ(installing.exitCode, 0) << installing.err;
  const fs::path share = folder.path() / "share";
  const std::string entry = core::readTextFile(share / "applications/skydrop.desktop");
  EXPECT_NE(entry.find("\nExec=skydrop\n"), std::string::npos);
  EXPECT_NE(entry.find("\nIcon=skydrop\n"), std::string::npos);
  EXPECT_TRUE(fs::exists(share / "icons/hicolor/scalable/apps/skydrop.svg"));
  EXPECT_TRUE(fs::exists(folder.path() / "bin/skydrop"));
  EXPECT_FALSE(fs::exists(share / "skydrop/assets/scripts")) << "what makes assets is for developers";
  const auto judge = findProgram("appstreamcli");
  if (!judge) GTEST_SKIP() << "no appstreamcli";
  const ProcessResult valid =
      runProcess({*judge, "validate", "--no-net", (share / "metainfo/skydrop.metainfo.xml").string()});
  // The program has no domain of its own to name itself by: that is the one warning.
  std::istringstream lines(valid.out);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("W: ") || line.starts_with("E: ")) {
      EXPECT_NE(line.find("cid-desktopapp-is-not-rdns"), std::string::npos) << line;
    }
  }
  EXPECT_NE(valid.out.find("cid-desktopapp-is-not-rdns"), std::string::npos) << valid.out << valid.err;
}

}  // namespace
}  // namespace skydrop::test
