#include "skydrop/core/settings_file.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "skydrop/core/error.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace skydrop::core {
namespace {

TEST(SettingsFile, whatWasWrittenIsReadBack) {
  // Members beside the settings are kept; the folder is made; the schema is ours whatever the caller says.
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "new" / "a.json";
  writeSettingsFile(file, {{"schema", 99}, {"settings", {{"a", 0.1}}}, {"groups", {"a"}}});
  const nlohmann::json json = readSettingsFile(file, {"groups"});
  EXPECT_EQ(json["settings"]["a"], 0.1);
  EXPECT_EQ(json["groups"][0], "a");
  EXPECT_EQ(json["schema"], kSettingsSchema);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(file.parent_path()), {}), 1)
      << "no temporary is left";
}

TEST(SettingsFile, whatIsNoSettingsFileIsRefusedByName) {
  const test::TemporaryFolder folder;
  for (const char* broken :
       {"", "{", "[]", "7", R"({"settings": {}})", R"({"schema": 2, "settings": {}})", R"({"schema": "1"})",
        R"({"schema": 1, "settings": []})", R"({"schema": 1, "settings": {}, "settings": {}})"}) {
    const std::filesystem::path file = folder.write("a.json", broken);
    const std::string line = test::refusalOf<DataError>([&] { readSettingsFile(file, {}); });
    EXPECT_NE(line.find("a.json"), std::string::npos) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  }
  EXPECT_THROW(readSettingsFile(folder.path() / "none.json", {}), DataError);
  EXPECT_EQ(readSettingsFile(folder.write("b.json", R"({"schema": 1})"), {})["settings"],
            nlohmann::json::object());
}

TEST(SettingsFile, membersThatNobodyKnowsAreRefusedUnlessTheyAreToBeKept) {
  // A shipped or named file says what it means; the player's own may come from a newer version.
  const std::string text = R"({"schema": 1, "groups": [], "wings": 2})";
  EXPECT_EQ(test::refusalOf<DataError>([&] { parseSettings(text, "a.json", {"groups"}); }),
            "a.json: wings: unknown member");
  EXPECT_EQ(parseSettings(text, "a.json", {"groups"}, UnknownMembers::keep)["wings"], 2);
  EXPECT_EQ(test::refusalOf<DataError>([&] { parseSettings(text, "a.json", {}, UnknownMembers::refuse); }),
            "a.json: groups: unknown member");
}

}  // namespace
}  // namespace skydrop::core
