#include <utility>

#include "ui/menu_fixture.h"

namespace skydrop::ui {
namespace {

class MenuTypingTest : public MenuFixture {};

TEST_F(MenuTypingTest, aTypedValueIsTakenExactlyOrRefusedWithALine) {
  // No rounding to the slider's five digits; out of range and no number change nothing and are reported.
  startTyping("aircraft.rollFactor");
  EXPECT_TRUE(app::ImGuiInput::wantsText()) << "keys go to the field";
  typeAndEnter("0.123456789012345");
  EXPECT_EQ(settings.aircraft.rollFactor, 0.123456789012345);
  EXPECT_FALSE(app::ImGuiInput::wantsText());
  const float top = place("aircraft.rollFactor").value.top;
  EXPECT_EQ(menu.place("refusal"), nullptr);
  for (const char* refused : {"99", "-1e-9", "fast", "nan", ""}) {
    startTyping("aircraft.rollFactor");
    if (*refused) {
      driver.type(refused);
    } else {
      driver.tap(app::key::kBackspace);
    }
    driver.tap(app::key::kEnter);
    EXPECT_EQ(settings.aircraft.rollFactor, 0.123456789012345) << refused;
    EXPECT_NE(menu.place("refusal"), nullptr) << refused;
    EXPECT_EQ(place("aircraft.rollFactor").value.top, top) << "rows stay under the mouse: " << refused;
  }
  startTyping("aircraft.rollFactor");
  typeAndEnter("2");
  EXPECT_EQ(settings.aircraft.rollFactor, 2);
  EXPECT_EQ(menu.place("refusal"), nullptr);
}

TEST_F(MenuTypingTest, aTypedValueMayCarryItsUnit) {
  startTyping("aircraft.mass");
  typeAndEnter("950.5 kg");
  EXPECT_EQ(settings.aircraft.mass, 950.5);
}

TEST_F(MenuTypingTest, escapeLeavesATypedValueAsItWas) {
  startTyping("aircraft.rollFactor");
  driver.type("1.5");
  driver.tap(app::key::kEscape);
  EXPECT_EQ(settings.aircraft.rollFactor, 0.75);
  EXPECT_TRUE(changed.empty());
}

TEST_F(MenuTypingTest, tabTypesOnInTheNextRow) {
  // And Shift with Tab in the one before; rows that are not numbers are passed over.
  startTyping("aircraft.mass");
  driver.type("900");
  driver.tap(app::key::kTab);
  EXPECT_EQ(settings.aircraft.mass, 900);
  driver.frames(3);
  driver.type("3");
  driver.tap(app::key::kTab);
  EXPECT_EQ(settings.aircraft.blades, 3);
  driver.frames(3);
  typeAndEnter("12");
  EXPECT_EQ(settings.aircraft.wing.span, 12);
}

TEST_F(MenuTypingTest, aDoubleClickTypesAndTakesBackWhatItsFirstClickMoved) {
  for (const char* path : {"aircraft.rollFactor", "aircraft.mass"}) {
    const double before = table.at(path).get();
    const ScreenRect rect = place(path).value;
    const ScreenRect end{rect.right - 8, rect.top, rect.right - 6, rect.bottom};  // far from the value
    driver.click(end);
    driver.click(end);
    driver.frames(3);
    EXPECT_EQ(table.at(path).get(), before);
    EXPECT_TRUE(app::ImGuiInput::wantsText());
    typeAndEnter("1.25");
    EXPECT_EQ(table.at(path).get(), 1.25);
    driver.frames(30);
    EXPECT_EQ(table.at(path).get(), 1.25);
    clickOn("undo");
    EXPECT_EQ(table.at(path).get(), before) << "the clicks left no step of their own";
  }
}

TEST_F(MenuTypingTest, aClickOnASlowSliderTakesEffectOnceNoSecondOneCanFollow) {
  const ScreenRect rect = place("aircraft.mass").value;
  driver.click({rect.right - 8, rect.top, rect.right - 6, rect.bottom});
  EXPECT_EQ(settings.aircraft.mass, 1200);
  driver.frames(30);  // half a second
  EXPECT_GT(settings.aircraft.mass, 50000);
  EXPECT_THAT(changed, ::testing::ElementsAre("aircraft.mass"));
}

TEST_F(MenuTypingTest, aSliderWhoseChangesRebuildAPartIsFollowedWhileItIsHeld) {
  sections = {{"weather", "Weather", true}};
  driver.frames(2);
  drag("weather.cell", 0.5f, 0.9f);
  driver.frames(2);
  const double held = settings.weather.cell;
  EXPECT_GT(held, 64) << "not released yet";
  release("weather.cell", 0.9f);
  EXPECT_EQ(settings.weather.cell, held);
}

TEST_F(MenuTypingTest, aRangeTooWideForASliderIsTypedOrRefused) {
  sections = {{"weather", "Weather", true}};
  driver.frames(2);
  for (const auto& [typed, expected] :
       {std::pair("-5", std::int64_t{7}), std::pair("123456789012", 123456789012)}) {
    driver.click(place("weather.seed").value);
    driver.frames(3);
    typeAndEnter(typed);
    EXPECT_EQ(settings.weather.seed, expected);
  }
}

}  // namespace
}  // namespace skydrop::ui
