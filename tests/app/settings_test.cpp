#include "app/settings/settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "app/session/effect_table.h"
#include "app/session/run_config.h"
#include "app/settings/user_settings.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "support/as_nobody.h"
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
  // Each field has a help sentence, a unit (numbers), a range that holds its default, a slider within the
  // range that does too, and a path of its own.
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
    EXPECT_GE(field.sliderMin, field.min) << field.path;
    EXPECT_LE(field.sliderMax, field.max) << field.path;
    EXPECT_GE(field.defaultValue, field.sliderMin) << field.path;
    EXPECT_LE(field.defaultValue, field.sliderMax) << field.path;
    if (field.logarithmic || field.powersOfTwo) {
      EXPECT_GT(field.sliderMin, 0) << field.path;
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
  const std::string layer = "clouds.layers.0";
  const auto first = std::ranges::find(table.fields(), layer, &core::Field::group);
  std::size_t i = 0;
  for (auto field = first; field != table.fields().end() && field->group == layer; ++field, ++i) {
    EXPECT_EQ(ui::sectionOf(sections, *field)->title, "Low clouds") << field->path;
    if (field->kind == core::FieldKind::number) {
      EXPECT_TRUE(core::isWhileHeld(field->takesEffect)) << field->path;
    }
    if (i >= std::size(values)) continue;
    EXPECT_EQ(field->path, layer + "." + values[i].first);
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

TEST(Settings, anEditedPlayerFileTakesEffectWhereItFits) {
  const test::TemporaryFolder folder;
  CommandLine line;
  line.verb = Verb::simulate;
  line.userDir = folder.path();
  line.set = {"aircraft.yawSpeed=31"};
  const auto run = prepareRun(line);
  folder.write("settings.json",
               R"({"schema": 1, "settings": {"aircraft": {"pitchSpeed": 21, "yawSpeed": 22}}})");
  EXPECT_EQ(reloadPlayer(*run).paths(), std::vector<std::string>{"aircraft.pitchSpeed"})
      << "--set still wins";
  EXPECT_EQ(run->settings.aircraft.pitchSpeed, 21);
  EXPECT_EQ(run->player.aircraft.yawSpeed, 22);
  EXPECT_EQ(run->warning, std::nullopt);
  folder.write("settings.json",
               R"({"schema": 1, "settings": {"aircraft": {"pitchSpeed": 25, "yawSpeed": -1, "wings": 2}}})");
  EXPECT_EQ(reloadPlayer(*run).paths(), std::vector<std::string>{"aircraft.pitchSpeed"});
  EXPECT_EQ(run->settings.aircraft.pitchSpeed, 25);
  ASSERT_TRUE(run->warning);
  EXPECT_THAT(*run->warning, testing::HasSubstr("aircraft.yawSpeed: -1 is out of range"));
  EXPECT_THAT(*run->warning, testing::HasSubstr("aircraft.wings: unknown setting"));
  folder.write("settings.json", R"({"schema": 1, "settings": {"aircraft": {"pitchSpeed": 27},}})");
  EXPECT_THROW(reloadPlayer(*run), core::DataError);
  EXPECT_EQ(run->settings.aircraft.pitchSpeed, 25) << "the last good state stays";
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "settings.json")) << "and so does the file";
}

// A run whose player's file is in a folder of the test's.
class UserSettingsTest : public testing::Test {
 protected:
  std::unique_ptr<app::RunConfig> start(const std::string& content = "") {
    if (!content.empty()) folder.write("settings.json", content);
    CommandLine line;
    line.verb = Verb::simulate;
    line.userDir = folder.path();
    return prepareRun(line);
  }
  static void change(app::RunConfig& run, const std::string& assignment) {
    core::setField(run.table, assignment);
    takeMenuChanges(run, {assignment.substr(0, assignment.find('='))});
  }
  static std::optional<std::string> save(app::RunConfig& run) {
    return run.userSettings.save(run.playerTable, run.bindings);
  }
  nlohmann::json kept() const { return nlohmann::json::parse(core::readTextFile(file)); }
  std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
      found.push_back(entry.path().filename().string());
    }
    std::ranges::sort(found);
    return found;
  }

  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "settings.json";
};

TEST_F(UserSettingsTest, whatWasChangedComesBackAndNothingElseIsWritten) {
  const auto run = start();
  save(*run);
  EXPECT_FALSE(std::filesystem::exists(file)) << "nothing to keep";
  change(*run, "aircraft.rollSpeed=40");
  EXPECT_EQ(save(*run), std::nullopt);
  EXPECT_EQ(kept(), nlohmann::json::parse(R"({"schema": 1, "settings": {"aircraft": {"rollSpeed": 40}}})"));
  EXPECT_EQ(start()->settings.aircraft.rollSpeed, 40);
  run->table.at("aircraft.rollSpeed").reset();
  takeMenuChanges(*run, {"aircraft.rollSpeed"});
  save(*run);
  EXPECT_EQ(kept(), nlohmann::json::parse(R"({"schema": 1})"));
}

TEST_F(UserSettingsTest, anEditByHandAndAChangeInTheMenuAreBothKept) {
  // The menu's own wins; what is not known stays where it stands, at every depth.
  const auto run = start(R"({"schema": 1, "settings": {"aircraft": {"mass": 1300, "pitchSpeed": 21}}})");
  change(*run, "aircraft.pitchSpeed=22");
  change(*run, "game.targetRadius=50");
  folder.write("settings.json", R"({"schema": 1, "note": [1, {"a": null}], "settings": {
    "aircraft": {"mass": 1200, "pitchSpeed": 24, "sails": {"area": 12}, "yawSpeed": "fast"}, "moon": 1}})");
  EXPECT_EQ(save(*run), std::nullopt);
  EXPECT_EQ(kept(), nlohmann::json::parse(R"({"schema": 1, "note": [1, {"a": null}], "settings": {
    "aircraft": {"mass": 1200, "pitchSpeed": 22, "sails": {"area": 12}, "yawSpeed": "fast"}, "moon": 1,
    "game": {"targetRadius": 50}}})"));
}

TEST_F(UserSettingsTest, aChangeThatIsNotSavedYetOutlivesAnEditByHand) {
  const auto run = start();
  change(*run, "aircraft.pitchSpeed=22");
  run->bindings.bind(Action::camera, keyInput('G'), 0);
  folder.write("settings.json",
               R"({"schema": 1, "settings": {"aircraft": {"mass": 1200}}, "bindings": {"mute": ["K"]}})");
  reloadPlayer(*run);
  EXPECT_EQ(run->settings.aircraft.mass, 1200);
  EXPECT_EQ(run->settings.aircraft.pitchSpeed, 22);
  EXPECT_EQ(run->bindings.actionOf(keyInput('G')), Action::camera);
  EXPECT_EQ(run->bindings.actionOf(keyInput('K')), Action::mute);
  save(*run);
  EXPECT_EQ(kept()["settings"]["aircraft"], nlohmann::json({{"mass", 1200}, {"pitchSpeed", 22}}));
  EXPECT_EQ(kept()["bindings"].size(), 2u) << kept();
}

TEST_F(UserSettingsTest, aFileBrokenWhileFlyingIsKeptAsideForTheLastGoodOne) {
  const auto run = start(R"({"schema": 1, "settings": {"aircraft": {"mass": 1200}}})");
  const std::string broken = R"({"schema": 1, "settings": {"aircraft": {"mass": 1100},}})";
  folder.write("settings.json", broken);
  const auto untouched = save(*run);
  ASSERT_TRUE(untouched) << "it is reported";
  EXPECT_EQ(core::readTextFile(file), broken) << "but nothing was to be written";
  int pitchSpeed = 20;
  for (const char* aside : {"settings.json.bad", "settings.json.bad2", "settings.json.bad3"}) {
    folder.write("settings.json", broken + aside);
    change(*run, "aircraft.pitchSpeed=" + std::to_string(++pitchSpeed));
    const auto line = save(*run);
    ASSERT_TRUE(line) << aside;
    EXPECT_THAT(*line, testing::HasSubstr((folder.path() / aside).string()));
    EXPECT_EQ(line->find('\n'), std::string::npos);
    EXPECT_EQ(core::readTextFile(folder.path() / aside), broken + aside);
    EXPECT_EQ(kept()["settings"]["aircraft"]["mass"], 1200);
    EXPECT_EQ(kept()["settings"]["aircraft"]["pitchSpeed"], run->player.aircraft.pitchSpeed);
  }
}

TEST_F(UserSettingsTest, theChoiceOfThePlayerOutlivesASceneThatHasTheSameValue) {
  // What equals the scene's value on one flight is a choice on the next one.
  folder.write("settings.json", R"({"schema": 1, "settings": {"aircraft": {"mass": 1200}}})");
  CommandLine line;
  line.verb = Verb::simulate;
  line.userDir = folder.path();
  line.scene = folder.write("scene.json", R"({"schema": 1, "settings": {"aircraft": {"mass": 1200}}})");
  const auto run = prepareRun(line);
  change(*run, "game.targetRadius=50");
  save(*run);
  EXPECT_EQ(kept()["settings"]["aircraft"]["mass"], 1200);
}

TEST_F(UserSettingsTest, evenAFolderInItsPlaceIsKeptAside) {
  const auto run = start();
  std::filesystem::create_directory(file);
  folder.write("settings.json/inner", "x");
  change(*run, "aircraft.pitchSpeed=22");
  const auto line = save(*run);
  ASSERT_TRUE(line);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "settings.json.bad/inner")) << "a folder is kept too";
  EXPECT_EQ(start()->settings.aircraft.pitchSpeed, 22);
}

TEST_F(UserSettingsTest, aFileThatMayNotBeReadIsLeftAlone) {
  // It need not be broken.
  const std::string content = R"({"schema": 1, "settings": {"aircraft": {"mass": 1200}}})";
  folder.write("settings.json", content);
  namespace fs = std::filesystem;
  fs::permissions(folder.path(), fs::perms::all);
  fs::permissions(file, fs::perms::none);
  {
    const test::AsNobody nobody;
    const auto run = start();
    ASSERT_TRUE(run->warning);
    EXPECT_THAT(*run->warning, testing::HasSubstr("Permission denied; defaults are used"));
    change(*run, "aircraft.pitchSpeed=22");
    EXPECT_THROW(save(*run), core::DataError);
  }
  fs::permissions(file, fs::perms::owner_read);
  EXPECT_EQ(core::readTextFile(file), content);
  EXPECT_EQ(names(), std::vector<std::string>{"settings.json"});
}

TEST_F(UserSettingsTest, boundKeysComeBack) {
  // They stand beside the settings. Entries of other versions stay, and so do those of the player's that are
  // not understood.
  const auto run = start();
  run->bindings.bind(Action::drop, keyInput('W'));
  save(*run);
  EXPECT_EQ(start()->bindings, run->bindings);
  nlohmann::json edited = kept();
  edited["bindings"]["hover"] = {"H"};
  edited["bindings"]["camera"] = {"ANY"};
  edited["bindings"]["mute"] = {"K"};
  const auto next = start(edited.dump());
  ASSERT_TRUE(next->warning);
  EXPECT_THAT(*next->warning, testing::HasSubstr("bindings.hover: is no action"));
  EXPECT_THAT(*next->warning, testing::HasSubstr("bindings.camera: \"ANY\" is no key"));
  EXPECT_EQ(next->bindings.actionOf(keyInput('W')), Action::drop);
  next->bindings.resetAction(Action::thrust);
  save(*next);
  EXPECT_EQ(kept()["bindings"]["hover"], nlohmann::json({"H"}));
  EXPECT_EQ(kept()["bindings"]["camera"], nlohmann::json({"ANY"}));
  EXPECT_EQ(kept()["bindings"]["mute"], nlohmann::json({"K"}));
  EXPECT_EQ(start()->bindings, next->bindings);
  folder.write("settings.json", R"({"schema": 1, "bindings": {"camera": ["G"]}})");
  reloadPlayer(*next);
  EXPECT_EQ(next->bindings.actionOf(keyInput('G')), Action::camera);
  EXPECT_EQ(next->bindings.actionOf(keyInput('K')), std::nullopt)
      << "what the file no longer changes is at its default";
}

TEST_F(UserSettingsTest, keysMovedAroundTheRulesAreSavedWhole) {
  // The menu's key moves to where another one was: on the way no rule may drop a change.
  const auto run = start();
  run->bindings.bind(Action::menu, keyInput(key::kF1 + 1), 0);
  run->bindings.bind(Action::help, keyInput(key::kF1), 0);
  save(*run);
  EXPECT_EQ(start()->bindings, run->bindings);
}

TEST_F(UserSettingsTest, aFlightNeverStartsFrozenBecauseTheLastOneWas) {
  const auto run = start();
  change(*run, "view.freezeTime=true");
  save(*run);
  EXPECT_FALSE(start()->settings.view.freezeTime);
}

TEST_F(UserSettingsTest, aFileThatIsBrokenAsAWholeIsKeptAsideUnderANewNameEachTime) {
  std::vector<std::string> expected;
  for (const char* broken :
       {"{", "[]", R"({"schema": 2})", R"({"schema": 1, "settings": {"aircraft": {"mass": 900},}})",
        R"({"schema": 1, "settings": 7})"}) {
    const auto run = start(broken);
    ASSERT_TRUE(run->warning) << broken;
    EXPECT_EQ(run->warning->find('\n'), std::string::npos);
    expected.push_back(expected.empty() ? "settings.json.bad"
                                        : "settings.json.bad" + std::to_string(expected.size() + 1));
    EXPECT_THAT(*run->warning, testing::EndsWith(expected.back())) << broken;
    EXPECT_EQ(core::readTextFile(folder.path() / expected.back()), broken);
    EXPECT_EQ(names(), expected);
    EXPECT_EQ(core::toJson(run->playerTable), core::toJson(run->baseTable)) << broken;
    EXPECT_EQ(run->bindings, Bindings()) << broken;
  }
}

TEST_F(UserSettingsTest, whatDoesNotFitIsSaidInOneLineAndTheRestApplies) {
  for (const auto& [wrong, reason] : {std::pair(R"("wings": 2)", "aircraft.wings: unknown setting"),
                                      std::pair(R"("mass": "x")", "aircraft.mass: \"x\" is not a number"),
                                      std::pair(R"("mass": -1)", "aircraft.mass: -1 is out of range"),
                                      std::pair(R"("mass": null)", "aircraft.mass: null is not a number")}) {
    const std::string content =
        std::string(R"({"schema": 1, "settings": {"game": 3, "aircraft": {"rollSpeed": 40, )") + wrong +
        "}}}";
    const auto run = start(content);
    ASSERT_TRUE(run->warning) << wrong;
    EXPECT_TRUE(run->warning->starts_with(file.string() + ": ")) << *run->warning;
    EXPECT_THAT(*run->warning, testing::HasSubstr(reason));
    EXPECT_THAT(*run->warning, testing::HasSubstr("game: is not an object"));
    EXPECT_EQ(run->warning->find('\n'), std::string::npos);
    EXPECT_EQ(run->settings.aircraft.rollSpeed, 40);
    EXPECT_EQ(run->settings.aircraft.mass, Settings().aircraft.mass);
    EXPECT_EQ(core::readTextFile(file), content);
  }
}

}  // namespace
}  // namespace skydrop::app
