#include <imgui.h>

#include <string>

#include "ui/menu_fixture.h"

namespace skydrop::ui {
namespace {

class MenuPresetsTest : public MenuFixture {};

TEST_F(MenuPresetsTest, presetsAreSavedLoadedAndDeletedOnlyWhenConfirmed) {
  presetList = {{"calm", "aircraft", true}, {"torn", "calm.json: JSON: bad", false}};
  presets = presetList;
  driver.frames(2);
  clickOn("presets");
  driver.click(ScreenRect(*menu.place("preset name")));
  driver.type("my own");
  driver.frames(1);
  clickOn("save preset");
  ASSERT_TRUE(request);
  EXPECT_EQ(request->kind, PresetRequest::Kind::save);
  EXPECT_EQ(request->name, "my own");
  EXPECT_TRUE(request->groups.empty()) << "every setting";
  request.reset();
  clickOn("load torn");
  EXPECT_FALSE(request) << "a broken one cannot be loaded";
  clickOn("load calm");
  ASSERT_TRUE(request);
  EXPECT_EQ(request->kind, PresetRequest::Kind::load);
  EXPECT_EQ(request->name, "calm");
  request.reset();
  clickOn("delete torn");
  EXPECT_FALSE(request);
  clickOn("save preset");  // a click elsewhere is a no
  request.reset();
  clickOn("delete torn");
  EXPECT_FALSE(request);
  clickOn("delete torn");
  ASSERT_TRUE(request);
  EXPECT_EQ(request->kind, PresetRequest::Kind::remove);
  EXPECT_EQ(request->name, "torn");
}

std::string clipboard;  // Dear ImGui asks for plain functions

TEST_F(MenuPresetsTest, theCopyButtonsFillTheClipboard) {
  ImGui::GetIO().SetClipboardTextFn = [](void*, const char* text) { clipboard = text; };
  settings.aircraft.mass = 900.1;
  base.aircraft.smoke = true;  // the scene's: no smoke is a change of ours
  pose = "--pose=1,2,3,4,5,6";
  driver.frames(2);
  clickOn("copy");
  clickOn("copy flags");
  EXPECT_EQ(clipboard, "--set aircraft.mass=900.1 --set aircraft.smoke=false");
  clickOn("copy pose");
  EXPECT_EQ(clipboard, "--pose=1,2,3,4,5,6");
}

}  // namespace
}  // namespace skydrop::ui
