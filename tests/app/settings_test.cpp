#include "app/settings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "app/parts.h"
#include "app/prepare.h"
#include "app/user_settings.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

// A value inside the field's range that is not its default.
double otherValue(const core::Field& field) {
  const double least = std::max(field.min, -1e6), most = std::min(field.max, 1e6);
  double value = field.kind == core::FieldKind::number ? least + 0.37 * (most - least) : least;
  if (value == field.defaultValue) value = field.kind == core::FieldKind::number ? most : least + 1;
  return value;
}

TEST(Settings, everyFieldIsDescribedWhole) {
  // Each field has a help sentence, a unit (numbers), a range that holds its default, and a path of its own.
  Settings settings;
  const core::SettingsTable table(settings);
  std::set<std::string> paths;
  EXPECT_GT(table.fields().size(), 60u);
  for (const core::Field& field : table.fields()) {
    EXPECT_TRUE(paths.insert(field.path).second) << field.path;
    EXPECT_GT(field.help.size(), 10u) << field.path;
    if (field.kind == core::FieldKind::number) {
      EXPECT_FALSE(field.unit.empty()) << field.path;
    }
    EXPECT_LT(field.min, field.max) << field.path;
    EXPECT_GE(field.defaultValue, field.min) << field.path;
    EXPECT_LE(field.defaultValue, field.max) << field.path;
    if (field.logarithmic) {
      EXPECT_GT(field.min, 0) << field.path;
    }
  }
}

TEST(Settings, allStructsSurviveJsonAndText) {
  // Every field set to something else reads back the same from JSON and from --set.
  Settings settings;
  const core::SettingsTable table(settings);
  for (const core::Field& field : table.fields()) core::setField(field, otherValue(field));
  Settings fromJson, fromText;
  const core::SettingsTable jsonTable(fromJson), textTable(fromText);
  core::applyJson(jsonTable, nlohmann::json::parse(core::toJson(table).dump()), "round.json");
  for (const core::Field& field : table.fields()) {
    core::setField(textTable, field.path + "=" + core::fieldText(field));
    EXPECT_NE(field.get(), field.defaultValue) << field.path;
    EXPECT_EQ(jsonTable.at(field.path).get(), field.get()) << field.path;
    EXPECT_EQ(textTable.at(field.path).get(), field.get()) << field.path;
  }
}

TEST(Settings, theThesisAircraftParametersHaveItsValues) {
  Settings settings;
  const core::SettingsTable table(settings);
  const std::pair<const char*, double> values[] = {
      {"rollFactor", .75},   {"stabilizingRoll", .5}, {"pitchSpeed", 20},        {"yawSpeed", 32.175},
      {"rollSpeed", 32.175}, {"maxThrottle", 198},    {"inducedYawFactor", .055}};
  std::size_t i = 0;
  for (const auto& [name, value] : values) {
    EXPECT_EQ(table.fields()[i].path, std::string("aircraft.") + name)
        << "they come first, in the thesis's order";
    EXPECT_EQ(table.fields()[i++].defaultValue, value) << name;
  }
}

TEST(Settings, theThesisWeatherParametersHaveRowsThatTakeEffectAtOnce) {
  // Its seven come first, in its order (density threshold, scale, HG, SIGMA, higher scale, weather scale,
  // cloud height), with its values where its units are ours; every number of the weather is live.
  Settings settings;
  const core::SettingsTable table(settings);
  const std::pair<const char*, double> values[] = {
      {"densityThreshold", .534}, {"scale", .595},       {"anisotropy", .119},  {"extinction", .08},
      {"higherScale", 20},        {"weatherScale", .02}, {"cloudHeight", 1555},
  };
  scene::EffectSet effects;
  effects.insert(scene::Effect::clouds);
  const auto sections = menuSections(effects);
  const auto first = std::ranges::find(table.fields(), "clouds", &core::Field::group);
  std::size_t i = 0;
  for (auto field = first; field != table.fields().end() && field->group == "clouds"; ++field, ++i) {
    EXPECT_EQ(ui::sectionOf(sections, *field)->title, "Weather") << field->path;
    if (field->kind == core::FieldKind::number) {
      EXPECT_EQ(field->takesEffect, core::TakesEffect::live) << field->path;
    }
    if (i >= std::size(values)) continue;
    EXPECT_EQ(field->path, std::string("clouds.") + values[i].first);
    EXPECT_EQ(field->defaultValue, values[i].second) << field->path;
  }
  EXPECT_GT(i, std::size(values));
}

TEST(Settings, everyEndOfEveryRowOfTheCloudsIsAccepted) {
  // By --set, as by a slider that is pulled to its end; what lies a little beyond is refused.
  Settings settings;
  const core::SettingsTable table(settings);
  CommandLine line;
  line.verb = Verb::simulate;
  int rows = 0;
  for (const core::Field& field : table.fields()) {
    if (!field.path.starts_with("clouds.")) continue;
    ++rows;
    for (const double end : {field.min, field.max}) {
      core::setField(field, end);
      line.set = {field.path + "=" + core::fieldText(field)};
      EXPECT_EQ(prepareRun(line)->table.at(field.path).get(), end) << line.set[0];
    }
    if (field.kind != core::FieldKind::number) continue;
    for (const double beyond : {std::nextafter(field.min, -1e9), std::nextafter(field.max, 1e9)}) {
      EXPECT_THROW(core::setField(field, beyond), core::RangeError) << field.path;
    }
  }
  EXPECT_GT(rows, 20);
}

TEST(Settings, theMenuOfTheWholeGameHasEveryFieldInOneSection) {
  // A setting that no section shows could not be tuned; in two it would have two rows.
  Settings settings;
  const core::SettingsTable table(settings);
  scene::EffectSet all;
  for (std::size_t i = 0; i < scene::kEffectNames.size(); ++i) all.insert(static_cast<scene::Effect>(i));
  const auto sections = menuSections(all);
  std::set<std::string> groups;
  for (const ui::MenuSection& section : sections) EXPECT_TRUE(groups.insert(section.group).second);
  for (const core::Field& field : table.fields()) {
    EXPECT_NE(ui::sectionOf(sections, field), nullptr) << field.path;
  }
}

TEST(Settings, laterSourcesWin) {
  // Defaults, then the scene, then the player's file, then --set.
  const test::TemporaryFolder folder;
  const std::string scene = folder.write(
      "a.json",
      R"({"schema": 1, "settings": {"aircraft": {"rollFactor": 0.1, "pitchSpeed": 11, "yawSpeed": 12}}})");
  folder.write("settings.json",
               R"({"schema": 1, "settings": {"aircraft": {"pitchSpeed": 21, "yawSpeed": 22}}})");
  CommandLine line;
  line.verb = Verb::simulate;
  line.scene = scene;
  line.set = {"aircraft.yawSpeed=31"};
  EXPECT_EQ(prepareRun(line)->settings.aircraft.pitchSpeed, 11)
      << "the player's file is read where it is named only";
  line.userDir = folder.path();
  const auto run = prepareRun(line);
  EXPECT_EQ(run->settings.aircraft.rollFactor, 0.1);
  EXPECT_EQ(run->settings.aircraft.pitchSpeed, 21);
  EXPECT_EQ(run->settings.aircraft.yawSpeed, 31);
  EXPECT_EQ(run->player.aircraft.yawSpeed, 22) << "--set is not saved";
}

TEST(Settings, aReloadKeepsWhatThePlayerChose) {
  const test::TemporaryFolder folder;
  CommandLine line;
  line.verb = Verb::simulate;
  line.scene = folder.write("a.json", R"({"schema": 1, "settings": {"aircraft": {"pitchSpeed": 11}}})");
  const auto run = prepareRun(line);
  run->table.at("aircraft.yawSpeed").set(40);
  takeMenuChanges(*run, {"aircraft.yawSpeed"});
  folder.write("a.json", R"({"schema": 1, "settings": {"aircraft": {"pitchSpeed": 15}}})");
  reloadScene(*run, line);
  EXPECT_EQ(run->settings.aircraft.pitchSpeed, 15);
  EXPECT_EQ(run->settings.aircraft.yawSpeed, 40);
  folder.write("a.json", R"({"schema": 1, "settings": {"aircraft": {"pitchSpeed": -15}}})");
  EXPECT_THROW(reloadScene(*run, line), core::DataError);
  EXPECT_EQ(run->settings.aircraft.pitchSpeed, 15) << "the last good state stays";
}

TEST(Settings, anEditedPlayerFileTakesEffectWholeOrNotAtAll) {
  const test::TemporaryFolder folder;
  CommandLine line;
  line.verb = Verb::simulate;
  line.userDir = folder.path();
  line.set = {"aircraft.yawSpeed=31"};
  const auto run = prepareRun(line);
  folder.write("settings.json",
               R"({"schema": 1, "settings": {"aircraft": {"pitchSpeed": 21, "yawSpeed": 22}}})");
  EXPECT_EQ(reloadPlayer(*run), std::vector<std::string>{"aircraft.pitchSpeed"}) << "--set still wins";
  EXPECT_EQ(run->settings.aircraft.pitchSpeed, 21);
  EXPECT_EQ(run->player.aircraft.yawSpeed, 22);
  folder.write("settings.json",
               R"({"schema": 1, "settings": {"aircraft": {"pitchSpeed": 25, "yawSpeed": -1}}})");
  EXPECT_THROW(reloadPlayer(*run), core::DataError);
  EXPECT_EQ(run->settings.aircraft.pitchSpeed, 21) << "the last good state stays";
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "settings.json")) << "and so does the file";
}

TEST(UserSettings, whatWasChangedComesBackAndNothingElseIsWritten) {
  const test::TemporaryFolder folder;
  Settings base, player;
  const core::SettingsTable baseTable(base), table(player);
  core::setField(table, "aircraft.rollSpeed=40");
  Bindings bindings;
  saveUserSettings(table, baseTable, bindings, folder.path() / "new");
  Settings back;
  const core::SettingsTable backTable(back);
  EXPECT_EQ(loadUserSettings(backTable, bindings, folder.path() / "new"), std::nullopt);
  EXPECT_EQ(back.aircraft.rollSpeed, 40);
  const auto json = nlohmann::json::parse(core::readTextFile(folder.path() / "new/settings.json"));
  EXPECT_EQ(json["settings"].size(), 1u);
  EXPECT_EQ(json["settings"]["aircraft"].size(), 1u);
  EXPECT_FALSE(json.contains("bindings"));
}

TEST(UserSettings, boundKeysComeBack) {
  // They stand beside the settings; an edit of the file is taken up whole or not at all.
  const test::TemporaryFolder folder;
  Settings settings;
  const core::SettingsTable table(settings);
  Bindings bindings;
  bindings.bind(Action::drop, keyInput('W'));
  saveUserSettings(table, table, bindings, folder.path());
  Bindings back;
  EXPECT_EQ(loadUserSettings(table, back, folder.path()), std::nullopt);
  EXPECT_EQ(back, bindings);

  CommandLine line;
  line.verb = Verb::simulate;
  line.userDir = folder.path();
  const auto run = prepareRun(line);
  EXPECT_EQ(run->bindings, bindings);
  folder.write("settings.json",
               R"({"schema": 1, "bindings": {"camera": ["V"]}, "settings": {"aircraft": {"mass": -1}}})");
  EXPECT_THROW(reloadPlayer(*run), core::DataError);
  EXPECT_EQ(run->bindings, bindings);
  folder.write("settings.json", R"({"schema": 1, "bindings": {"camera": ["V"]}})");
  reloadPlayer(*run);
  EXPECT_EQ(run->bindings.actionOf(keyInput('V')), Action::camera);
  EXPECT_EQ(run->bindings.actionOf(keyInput('W')), Action::thrust)
      << "what the file no longer changes is at its default";
}

TEST(UserSettings, aFlightNeverStartsFrozenBecauseTheLastOneWas) {
  const test::TemporaryFolder folder;
  Settings base, player;
  const core::SettingsTable baseTable(base), table(player);
  core::setField(table, "view.freezeTime=true");
  Bindings bindings;
  saveUserSettings(table, baseTable, bindings, folder.path());
  Settings back;
  EXPECT_EQ(loadUserSettings(core::SettingsTable(back), bindings, folder.path()), std::nullopt);
  EXPECT_FALSE(back.view.freezeTime);
}

TEST(UserSettings, aBrokenFileIsReportedKeptAsideAndReplacedByDefaults) {
  const test::TemporaryFolder folder;
  for (const char* broken :
       {"{", "[]", R"({"schema": 2})", R"({"schema": 1, "settings": {"aircraft": {"mass": "x"}}})",
        R"({"schema": 1, "settings": {"aircraft": {"rollSpeed": 40, "mass": -1}}})",
        R"({"schema": 1, "settings": {"aircraft": {"rollSpeed": 40}}, "bindings": {"fly": []}})",
        R"({"schema": 1, "bindings": {"drop": ["V"], "camera": ["ANY"]}})"}) {
    folder.write("settings.json", broken);
    Settings settings;
    const core::SettingsTable table(settings);
    Bindings bindings;
    const std::optional<std::string> warning = loadUserSettings(table, bindings, folder.path());
    ASSERT_TRUE(warning) << broken;
    EXPECT_NE(warning->find("settings.json"), std::string::npos);
    EXPECT_EQ(warning->find('\n'), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "settings.json"));
    EXPECT_EQ(core::readTextFile(folder.path() / "settings.json.bad"), broken);
    EXPECT_EQ(core::toJson(table, true), nlohmann::json::object()) << broken;
    EXPECT_EQ(bindings, Bindings()) << broken;
  }
}

}  // namespace
}  // namespace skydrop::app
