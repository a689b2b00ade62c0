#include "app/window/menu_controller.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/session/pose_text.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/flag_text.h"
#include "skydrop/render/frame/camera.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

render::View someView() { return render::Camera().view({}, {}, 640, 360); }

TEST(MenuController, theCopiedFlagsReproduceEverySettingFromTheSceneAndFromTheDefaults) {
  // What stands between the two on the player's machine (a quality, a scene) need not be known to the flags.
  Settings base, settings;
  const core::SettingsTable baseTable(base), table(settings);
  base.streaming.pixelError = settings.streaming.pixelError = 7;  // of the machine
  base.aircraft.mass = 900;                                       // the scene's, reset by the player
  for (const core::Field& field : table.fields()) {
    if (field.kind != core::FieldKind::number || !field.path.starts_with("render.")) continue;
    core::setField(field, field.min + (field.max - field.min) / 3);
  }
  MenuController menuController(std::nullopt);
  const ui::MenuTools tools = menuController.tools(baseTable, someView(), {});
  EXPECT_FALSE(tools.presets) << "no folder, no presets";
  std::istringstream words(core::setFlags(table, tools.bases));
  std::vector<std::string> assignments;
  for (std::string flag, assignment; words >> flag >> assignment;) {
    EXPECT_EQ(flag, "--set");
    assignments.push_back(assignment);
  }
  for (const Settings& start : {base, Settings()}) {
    Settings again = start;
    const core::SettingsTable againTable(again);
    applyOverrides(againTable, assignments);
    for (std::size_t i = 0; i < table.fields().size(); ++i) {
      EXPECT_EQ(againTable.fields()[i].get(), table.fields()[i].get()) << table.fields()[i].path;
    }
  }
  EXPECT_EQ(tools.pose, poseText(poseOf(someView())));
}

TEST(MenuController, presetsAreServedThroughTheMenu) {
  // Saved with what the table has; loaded as one step of its history; a refusal changes nothing.
  const test::TemporaryFolder folder;
  MenuController menuController(folder.path());
  ui::ConfigurationMenu menu;
  Settings settings;
  const core::SettingsTable table(settings);
  settings.aircraft.mass = 900;
  using Kind = ui::PresetRequest::Kind;
  menuController.serve({Kind::save, "light", {"aircraft"}}, table, menu);
  ASSERT_EQ(menuController.tools(table, someView(), {}).presets.value().size(), 1u);
  settings.aircraft.mass = 1500;
  const MenuController::Served served = menuController.serve({Kind::load, "light"}, table, menu);
  EXPECT_EQ(served.changedPaths, std::vector<std::string>{"aircraft.mass"});
  EXPECT_EQ(settings.aircraft.mass, 900);
  EXPECT_THROW(menuController.serve({Kind::load, "heavy"}, table, menu), core::DataError);
  EXPECT_THROW(menuController.serve({Kind::save, "a/b"}, table, menu), core::RangeError);
  EXPECT_EQ(settings.aircraft.mass, 900);
  menuController.serve({Kind::remove, "light"}, table, menu);
  EXPECT_TRUE(menuController.tools(table, someView(), {}).presets.value().empty());
}

TEST(MenuController, theMenuIsRememberedAndABrokenMemoryIsSetAside) {
  const test::TemporaryFolder folder;
  MenuController menuController(folder.path());
  ui::ConfigurationMenu menu;
  EXPECT_EQ(menuController.load(menu), std::nullopt) << "no file is as good as none";
  menuController.save(menu);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "menu.json")) << "nothing to remember";
  menu.setState({ui::ScreenRect{0.25f, 0.1f, 0.6f, 0.9f}, {{"aircraft", false}, {"#costs", true}}});
  menuController.save(menu);
  ui::ConfigurationMenu next;
  MenuController nextDesk(folder.path());
  EXPECT_EQ(nextDesk.load(next), std::nullopt);
  EXPECT_EQ(next.state().open, menu.state().open);
  EXPECT_EQ(next.state().place.value().right, 0.6f);
  for (const char* broken : {"{", R"({"schema": 2})"}) {
    std::filesystem::remove(folder.path() / "menu.json.bad");
    folder.write("menu.json", broken);
    ui::ConfigurationMenu fresh;
    EXPECT_TRUE(MenuController(folder.path()).load(fresh)) << broken;
    EXPECT_FALSE(fresh.state().place) << broken;
    EXPECT_EQ(core::readTextFile(folder.path() / "menu.json.bad"), broken);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "menu.json"));
  }
  for (const char* wrong :
       {R"({"schema": 1, "place": [0, 0, 1]})", R"({"schema": 1, "place": [0, 0, 1, 7]})",
        R"({"schema": 1, "open": {"aircraft": 3, "game": true}})", R"({"schema": 1, "open": 3})"}) {
    folder.write("menu.json", wrong);
    ui::ConfigurationMenu fresh;
    const auto warning = MenuController(folder.path()).load(fresh);
    ASSERT_TRUE(warning) << wrong;
    EXPECT_TRUE(warning->starts_with((folder.path() / "menu.json").string())) << *warning;
    EXPECT_EQ(warning->find('\n'), std::string::npos) << *warning;
    EXPECT_FALSE(fresh.state().place) << wrong;
    EXPECT_EQ(fresh.state().open.contains("game"), std::string(wrong).find("game") != std::string::npos);
  }
}

TEST(MenuController, onlyWhatChangedInTheMenuIsWritten) {
  const test::TemporaryFolder folder;
  folder.write("menu.json", R"({"schema": 1, "open": {"aircraft": true, "game": true}})");
  MenuController menuController(folder.path());
  ui::ConfigurationMenu menu;
  menuController.load(menu);
  const std::string edited = folder.write(
      "menu.json",
      R"({"schema": 1, "open": {"aircraft": true, "game": false, "sails": true}, "colour": "red"})");
  ui::MenuState state = menu.state();
  state.open["aircraft"] = false;
  menu.setState(state);
  EXPECT_EQ(menuController.save(menu), std::nullopt);
  EXPECT_EQ(
      nlohmann::json::parse(core::readTextFile(edited)),
      nlohmann::json::parse(
          R"({"schema": 1, "open": {"aircraft": false, "game": false, "sails": true}, "colour": "red"})"));
}

}  // namespace
}  // namespace skydrop::app
