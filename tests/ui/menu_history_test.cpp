#include <vector>

#include "skydrop/core/error.h"
#include "ui/menu_fixture.h"

namespace skydrop::ui {
namespace {

class MenuHistoryTest : public MenuFixture {};

TEST_F(MenuHistoryTest, aDragIsOneStepThatUndoAndRedoTakeWhole) {
  const ScreenRect rect = place("aircraft.rollFactor").value;
  drag("aircraft.rollFactor", 0.4f, 0.6f);
  for (const float to : {0.7f, 0.8f, 0.9f}) {
    driver.move(rect.left + to * (rect.right - rect.left), (rect.top + rect.bottom) / 2);
  }
  release("aircraft.rollFactor", 0.9f);
  const double dragged = settings.aircraft.rollFactor;
  EXPECT_GT(dragged, 1.5);
  changed.clear();
  clickOn("undo");
  EXPECT_EQ(settings.aircraft.rollFactor, 0.75);
  EXPECT_THAT(changed, ::testing::ElementsAre("aircraft.rollFactor")) << "the caller hears of it";
  clickOn("redo");
  EXPECT_EQ(settings.aircraft.rollFactor, dragged);
  chord('Z');
  EXPECT_EQ(settings.aircraft.rollFactor, 0.75);
  chord('Y');
  EXPECT_EQ(settings.aircraft.rollFactor, dragged);
  chord('Z');
  chord('Z', true);
  EXPECT_EQ(settings.aircraft.rollFactor, dragged) << "Shift turns it round";
  clickOn("redo");
  EXPECT_EQ(settings.aircraft.rollFactor, dragged) << "nothing more to do again";
}

TEST_F(MenuHistoryTest, controlZInATextFieldIsTheFieldsOwn) {
  settings.aircraft.rollFactor = 1;
  driver.frames(1);
  driver.click(*place("aircraft.rollFactor").reset);
  startTyping("aircraft.rollFactor");
  chord('Z');
  EXPECT_EQ(settings.aircraft.rollFactor, 0.75);
  driver.tap(app::key::kEscape);
  chord('Z');
  EXPECT_EQ(settings.aircraft.rollFactor, 1);
}

TEST_F(MenuHistoryTest, resetAllIsUndoneAsOneStep) {
  settings.aircraft = {1, 2, 3, true, Quality::high, {4}};
  driver.frames(1);
  clickOn("reset all");
  EXPECT_EQ(settings.aircraft.mass, 1200);
  changed.clear();
  clickOn("undo");
  EXPECT_EQ(changed.size(), 6u);
  EXPECT_EQ(settings.aircraft.rollFactor, 1);
  EXPECT_EQ(settings.aircraft.mass, 2);
  EXPECT_EQ(settings.aircraft.blades, 3);
  EXPECT_TRUE(settings.aircraft.smoke);
  EXPECT_EQ(settings.aircraft.quality, Quality::high);
  EXPECT_EQ(settings.aircraft.wing.span, 4);
}

TEST_F(MenuHistoryTest, valuesFromOutsideAreOneStepOrRefusedWhole) {
  const std::vector<SettingValue> values = {
      {"aircraft.mass", 900}, {"aircraft.smoke", 1}, {"weather.scale", 0.595}};
  EXPECT_THAT(menu.change(table, values), ::testing::ElementsAre("aircraft.mass", "aircraft.smoke"));
  EXPECT_EQ(settings.aircraft.mass, 900);
  const std::vector<SettingValue> bad = {{"aircraft.rollFactor", 1}, {"aircraft.mass", 0}};
  EXPECT_THROW(menu.change(table, bad), core::RangeError);
  EXPECT_EQ(settings.aircraft.rollFactor, 0.75);
  driver.frames(1);
  clickOn("undo");
  EXPECT_EQ(settings.aircraft.mass, 1200);
  EXPECT_FALSE(settings.aircraft.smoke);
}

}  // namespace
}  // namespace skydrop::ui
