#include "app/window_memory.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "skydrop/core/file.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

TEST(WindowMemory, whatWasChangedComesBackAndNothingElseIsWritten) {
  const test::TemporaryFolder folder;
  WindowMemory usual, left;
  left.width = 900;
  left.moved = true;
  left.top = -20;
  saveWindowMemory(left, usual, folder.path() / "new");
  WindowMemory back;
  EXPECT_EQ(loadWindowMemory(back, folder.path() / "new"), std::nullopt);
  EXPECT_EQ(back.width, 900);
  EXPECT_EQ(back.height, usual.height);
  EXPECT_TRUE(back.moved);
  EXPECT_EQ(back.top, -20);
  const auto json = nlohmann::json::parse(core::readTextFile(folder.path() / "new/window.json"));
  EXPECT_EQ(json["settings"].size(), 3u) << json;
}

TEST(WindowMemory, aBrokenFileIsKeptAsideAndTheWindowOpensAsUsual) {
  const test::TemporaryFolder folder;
  for (const char* broken :
       {"{", R"({"schema": 1, "settings": {"width": 0}})", R"({"schema": 1, "settings": 3})"}) {
    folder.write("window.json", broken);
    WindowMemory memory;
    const auto warning = loadWindowMemory(memory, folder.path());
    ASSERT_TRUE(warning) << broken;
    EXPECT_EQ(warning->find('\n'), std::string::npos) << *warning;
    EXPECT_EQ(memory.width, WindowMemory().width);
    EXPECT_EQ(core::readTextFile(folder.path() / "window.json.bad"), broken);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "window.json"));
  }
}

}  // namespace
}  // namespace skydrop::app
