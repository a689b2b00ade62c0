#include "app/window/window_memory.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "skydrop/core/file.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

TEST(WindowMemory, whatWasChangedComesBackAndNothingElseIsWritten) {
  const test::TemporaryFolder folder;
  const WindowMemory usual;
  WindowMemory left;
  KeptFile file(windowMemoryFile(folder.path() / "new"));
  saveWindowMemory(usual, usual, usual, file);
  EXPECT_FALSE(std::filesystem::exists(file.path())) << "nothing to remember";
  left.width = 900;
  left.moved = true;
  left.top = -20;
  EXPECT_EQ(saveWindowMemory(left, usual, usual, file), std::nullopt);
  WindowMemory back;
  KeptFile again(file.path());
  EXPECT_EQ(loadWindowMemory(back, again), std::nullopt);
  EXPECT_EQ(back.width, 900);
  EXPECT_EQ(back.height, usual.height);
  EXPECT_TRUE(back.moved);
  EXPECT_EQ(back.top, -20);
  const auto json = nlohmann::json::parse(core::readTextFile(file.path()));
  EXPECT_EQ(json["settings"].size(), 3u) << json;
  saveWindowMemory(usual, back, usual, again);
  EXPECT_FALSE(nlohmann::json::parse(core::readTextFile(file.path())).contains("settings"));
}

TEST(WindowMemory, editsAndKeysOfOtherVersionsStay) {
  const test::TemporaryFolder folder;
  KeptFile file(folder.write("window.json", R"({"schema": 1, "settings": {"width": 900, "opacity": 0.5}})"));
  WindowMemory memory;
  const auto warning = loadWindowMemory(memory, file);
  EXPECT_EQ(warning, file.path().string() + ": opacity: unknown setting; not used, but kept");
  EXPECT_EQ(memory.width, 900);
  folder.write("window.json",
               R"({"schema": 1, "settings": {"width": 800, "opacity": 0.5}, "screen": "left"})");
  WindowMemory now = memory;
  now.top = 30;
  saveWindowMemory(now, memory, {}, file);
  EXPECT_EQ(nlohmann::json::parse(core::readTextFile(file.path())),
            nlohmann::json({{"schema", 1},
                            {"screen", "left"},
                            {"settings", {{"width", 800}, {"opacity", 0.5}, {"top", 30}}}}));
}

TEST(WindowMemory, whatIsWrongIsSaidInOneLineAndTheWindowOpensAsUsual) {
  // Broken as a whole the file is kept aside; a wrong value is left out.
  const test::TemporaryFolder folder;
  for (const char* broken :
       {"{", R"({"schema": 1, "settings": 3})", R"({"schema": 1, "settings": {"width": 0}})"}) {
    std::filesystem::remove(folder.path() / "window.json.bad");
    KeptFile file(folder.write("window.json", broken));
    WindowMemory memory;
    const auto warning = loadWindowMemory(memory, file);
    ASSERT_TRUE(warning) << broken;
    EXPECT_EQ(warning->find('\n'), std::string::npos) << *warning;
    EXPECT_EQ(memory.width, WindowMemory().width);
    const bool isWhole = std::string(broken).ends_with("}}");
    EXPECT_EQ(core::readTextFile(folder.path() / (isWhole ? "window.json" : "window.json.bad")), broken);
    EXPECT_EQ(std::filesystem::exists(folder.path() / "window.json"), isWhole);
  }
}

}  // namespace
}  // namespace skydrop::app
