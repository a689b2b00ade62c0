// The program as it is installed, wherever its tree is moved.
#include <gtest/gtest.h>

#include <algorithm>
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

TEST(InstalledProgram, readsModelsOfOthersByAChildOfItsOwn) {
  // From where the tree was moved to, on both back-ends without a display: another model than the one that
  // comes with the program is drawn, and one that is broken is refused in one line by its name.
  const TemporaryFolder folder;
  const fs::path first = folder.path() / "first", moved = folder.path() / "moved to";
  const ProcessResult installing = install(first);
  ASSERT_EQ(installing.exitCode, 0) << installing.err;
  fs::rename(first, moved);
  const fs::path model = moved / "share/skydrop/assets/models/package.glb",
                 corpus = fs::path(sourceDir()) / "tests/corpus/models";
  fs::copy_file(corpus / "white.png", model.parent_path() / "white.png");  // its texture
  const std::string picture = (folder.path() / "a.png").string();
  for (const char* backend : {"egl", "osmesa"}) {
    const auto renderWith = [&](const char* other) {
      fs::copy_file(corpus / other, model, fs::copy_options::overwrite_existing);
      return runProcess({(moved / "bin/skydrop").string(), "render", "--backend", backend, "--scene",
                         "terrain", "--size", "64x36", "--out", picture},
                        {"DISPLAY", "WAYLAND_DISPLAY", "LIBGL_ALWAYS_SOFTWARE=1", "SKYDROP_DATA_DIR",
                         "HOME=" + (folder.path() / "home").string(), "XDG_CACHE_HOME", "XDG_CONFIG_HOME"});
    };
    const ProcessResult good = renderWith("goodTriangle.glb");
    if (good.exitCode == 3) continue;  // a back-end that is not there
    EXPECT_EQ(good.exitCode, 0) << backend << ": " << good.err;
    const ProcessResult bad = renderWith("badIndex.glb");
    EXPECT_EQ(bad.exitCode, 1) << backend;
    EXPECT_NE(bad.err.find("package.glb"), std::string::npos) << backend << ": " << bad.err;
    EXPECT_EQ(std::ranges::count(bad.err, '\n'), 1) << bad.err;
  }
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
