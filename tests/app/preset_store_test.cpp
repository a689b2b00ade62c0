#include "app/settings/preset_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "app/session/run_config.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

class PresetStoreTest : public testing::Test {
 protected:
  static void apply(const core::SettingsTable& table, const std::vector<ui::SettingValue>& values) {
    for (const ui::SettingValue& value : values) core::setField(table.at(value.path), value.value);
  }

  test::TemporaryFolder folder;
  std::filesystem::path presets = folder.path() / "presets";
  PresetStore shelf{presets};
  Settings settings;
  core::SettingsTable table{settings};
};

TEST_F(PresetStoreTest, aPresetOfEverythingBringsEveryValueOfTheGameBack) {
  // Bit for bit, those that were at their default too; what is the player's own stays.
  for (const core::Field& field : table.fields()) {
    const double middle = field.min + (field.max - field.min) / 3;
    core::setField(field, field.kind == core::FieldKind::number ? middle : std::floor(middle));
  }
  table.at("aircraft.rollFactor").reset();
  shelf.save("first try", table, {});
  Settings other;
  const core::SettingsTable otherTable(other);
  other.aircraft.rollFactor = 1.1;
  other.view.hud = false;
  apply(otherTable, shelf.load("first try"));
  for (std::size_t i = 0; i < table.fields().size(); ++i) {
    const core::Field& field = table.fields()[i];
    if (field.path.starts_with("view") || field.path.starts_with("audio") || field.path == "quality" ||
        field.path.starts_with("effects"))
      continue;
    EXPECT_EQ(otherTable.fields()[i].get(), field.get()) << field.path;
  }
  EXPECT_FALSE(other.view.hud);
}

TEST_F(PresetStoreTest, aPresetOfASectionLeavesTheOthersAlone) {
  settings.aircraft.mass = 900;
  settings.game.targetRadius = 50;
  shelf.save("light", table, {"aircraft"});
  Settings other;
  const core::SettingsTable otherTable(other);
  other.aircraft.pitchSpeed = 11;
  other.game.targetRadius = 70;
  apply(otherTable, shelf.load("light"));
  EXPECT_EQ(other.aircraft.mass, 900);
  EXPECT_EQ(other.aircraft.pitchSpeed, Settings().aircraft.pitchSpeed)
      << "was at its default when it was saved";
  EXPECT_EQ(other.game.targetRadius, 70);
  EXPECT_THROW(shelf.save("x", table, {"airkraft"}), core::RangeError);
}

TEST_F(PresetStoreTest, onlyWhatDiffersIsWritten) {
  settings.aircraft.mass = 900;
  shelf.save("light", table, {"aircraft"});
  EXPECT_THAT(
      core::readTextFile(presets / "light.json"),
      testing::AllOf(testing::HasSubstr("\"mass\": 900"), testing::Not(testing::HasSubstr("rollFactor"))));
}

TEST_F(PresetStoreTest, presetsAreListedByNameAndDeleted) {
  EXPECT_TRUE(shelf.list().empty()) << "the folder need not exist";
  shelf.save("b", table, {"game"});
  shelf.save("a", table, {});
  std::ofstream(presets / "notes.txt") << "no preset";
  ASSERT_EQ(shelf.list().size(), 2u);
  EXPECT_EQ(shelf.list()[0].name, "a");
  EXPECT_EQ(shelf.list()[1].holds, "game");
  shelf.remove("a");
  EXPECT_EQ(shelf.list().size(), 1u);
  EXPECT_THROW(shelf.remove("a"), core::DataError);
}

TEST_F(PresetStoreTest, aBrokenPresetIsALineAndLosesNothing) {
  // It is listed with what is wrong, stays on the disk as it is, and nothing of it is applied.
  shelf.save("good", table, {});
  for (const char* broken :
       {"", "{", R"({"schema": 1, "settings": {}})", R"({"schema": 1, "groups": [], "settings": {}})",
        R"({"schema": 1, "groups": ["sails"], "settings": {}})",
        R"({"schema": 1, "groups": [7], "settings": {}})",
        R"({"schema": 9, "groups": ["aircraft"], "settings": {}})",
        R"({"schema": 1, "groups": ["aircraft"], "settings": {"aircraft": {"mass": -1}}})",
        R"({"schema": 1, "groups": ["aircraft"], "settings": {"game": {"targetRadius": 50}}})"}) {
    std::ofstream(presets / "torn.json") << broken;
    const std::string message = test::refusalOf<std::exception>([&] { shelf.load("torn"); });
    EXPECT_THAT(message, testing::HasSubstr("torn.json")) << broken;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    const auto list = shelf.list();
    ASSERT_EQ(list.size(), 2u);
    EXPECT_FALSE(list[1].usable) << broken;
    EXPECT_EQ(list[1].holds, message);
    EXPECT_EQ(core::readTextFile(presets / "torn.json"), broken);
  }
}

TEST_F(PresetStoreTest, aPresetThatCannotBeReadIsNotWrittenOver) {
  // It may be one slip of a hand away from a good one.
  EXPECT_EQ(shelf.save("light", table, {"aircraft"}), std::nullopt);
  EXPECT_EQ(shelf.save("light", table, {"game"}), std::nullopt) << "a good one is replaced";
  for (const char* name : {"light.json.bad", "light.json.bad2"}) {
    std::ofstream(presets / "light.json") << name;
    EXPECT_EQ(shelf.save("light", table, {"game"}), presets / name);
    EXPECT_EQ(core::readTextFile(presets / name), name);
    ASSERT_EQ(shelf.list().size(), 1u);
    EXPECT_TRUE(shelf.list()[0].usable);
  }
}

TEST_F(PresetStoreTest, aNameIsNeverAPath) {
  for (const std::string name : {"", ".", "..", "../settings", "a/b", "a\\b", ".hidden", "dot.", " space",
                                 "space ", "tab\t", "c:", "*", "\xc3\xa4"}) {
    EXPECT_NE(presetNameRefusal(name), "") << name;
    EXPECT_THROW(shelf.save(name, table, {}), core::RangeError) << name;
    EXPECT_THROW(shelf.load(name), core::RangeError) << name;
    EXPECT_THROW(shelf.remove(name), core::RangeError) << name;
  }
  EXPECT_NE(presetNameRefusal(std::string("nul\0x", 5)), "");
  EXPECT_NE(presetNameRefusal(std::string(65, 'a')), "");
  EXPECT_EQ(presetNameRefusal(std::string(64, 'a')), "");
  EXPECT_EQ(presetNameRefusal("My first (calm) try_2.1"), "");
  EXPECT_FALSE(std::filesystem::exists(presets)) << "nothing was written";
}

TEST_F(PresetStoreTest, theCommandLineNamesAPresetOrAFile) {
  settings.aircraft.mass = 900;
  shelf.save("light", table, {"aircraft"});
  for (const std::string& word : {std::string("light"), (presets / "light.json").string()}) {
    Settings other;
    other.aircraft.pitchSpeed = 11;
    applyOverrides(core::SettingsTable(other), presetOfCommandLine(word, presets));
    EXPECT_EQ(other.aircraft.mass, 900);
    EXPECT_EQ(other.aircraft.pitchSpeed, Settings().aircraft.pitchSpeed);
  }
  EXPECT_THROW(presetOfCommandLine("heavy", presets), core::DataError);
  EXPECT_THROW(presetOfCommandLine("..", presets), core::UsageError);
  EXPECT_THROW(presetOfCommandLine("heavy.json", presets), core::DataError);
}

TEST_F(PresetStoreTest, aPresetOfTheCommandLineStandsBetweenThePlayersFileAndSet) {
  settings.aircraft.mass = 900;
  settings.aircraft.pitchSpeed = 22;
  shelf.save("light", table, {"aircraft"});
  folder.write("settings.json",
               R"({"schema": 1, "settings": {"aircraft": {"pitchSpeed": 21, "yawSpeed": 30}}})");
  CommandLine line;
  line.userDir = folder.path();
  line.preset = "light";
  line.set = {"aircraft.mass=950"};
  const auto run = prepareRun(withPreset(line));
  EXPECT_EQ(run->settings.aircraft.mass, 950);
  EXPECT_EQ(run->settings.aircraft.pitchSpeed, 22);
  EXPECT_EQ(run->settings.aircraft.yawSpeed, Settings().aircraft.yawSpeed) << "it holds the whole group";
  EXPECT_EQ(run->player.aircraft.pitchSpeed, 21) << "for this run only";
}

}  // namespace
}  // namespace skydrop::app
